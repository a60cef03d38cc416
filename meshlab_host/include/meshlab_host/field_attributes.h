// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"
#include "meshlab_host/geometry_stamp.h"

namespace meshlab_host {

/// A field is kept in per-vertex attributes that other filters can read and export: those of its
/// columns in laplacian_lines/field_columns.h, vectors as Point3m, numbers as Scalarm. The per-mesh
/// attribute ll_record describes them; without it, the field does not count.
struct FieldRecord {
    static constexpr std::uint32_t current_layout = 8;

    std::uint32_t layout = current_layout;
    std::uint32_t columns = 0;  ///< bit i: the field had the column of row i
    GeometryStamp stamp;        ///< of the mesh that the field was computed from
    /// A hash of the values: when a file is reloaded MeshLab keeps the record, but keeps the values
    /// in whatever order edits have left them, or clears them.
    std::uint64_t content = 0;
    laplacian_lines::PrecomputeOptions options;
    laplacian_lines::FieldScale scale;
    laplacian_lines::MeshReport report;
};

enum class FieldStatus {
    Current,
    Missing,    ///< never computed, or MeshLab has dropped or mixed up part of it
    Stale,      ///< the mesh has changed since
    WrongType,  ///< another program's or version's attribute has one of the names
};

/// For the log, after the name of a mesh; empty if there is nothing remarkable.
const char* describe(FieldStatus status);

/// Separated by commas.
QString field_attribute_names(const laplacian_lines::Field& field);

/// `now` is geometry_stamp(mesh).
FieldStatus field_status(const CMeshO& mesh, const GeometryStamp& now);

/// None if there is none of this version.
std::optional<FieldRecord> read_field_record(const CMeshO& mesh);

/// By live index (see mesh_conversion.h); empty unless field_status() is Current.
std::optional<laplacian_lines::Field> read_field(const CMeshO& mesh, const GeometryStamp& now);

/// Stores a field with an entry per live vertex; deleted vertices get zeros. Replaces attributes of
/// another type and removes those of absent columns. The record comes last: out of memory, the mesh
/// has no field rather than half of one. @throws laplacian_lines::Error(FieldMismatch),
/// std::bad_alloc
void write_field(CMeshO& mesh, const laplacian_lines::Field& field,
                 const laplacian_lines::PrecomputeOptions& options, const GeometryStamp& stamp);

}  // namespace meshlab_host
