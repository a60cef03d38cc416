// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "laplacian_lines/field.h"
#include "laplacian_lines/precompute_options.h"
#include "meshlab_host/geometry_stamp.h"

namespace meshlab_host {

/// A field on a mesh is kept in per-vertex attributes, which other filters can read and export: for
/// each column that the field has, those of its row in laplacian_lines/field_columns.h, vectors as
/// Point3m and numbers as Scalarm. A per-mesh attribute ll_record tells what they are; a field
/// without its record does not count.
struct FieldRecord {
    static constexpr std::uint32_t current_layout = 6;

    std::uint32_t layout = current_layout;
    std::uint32_t columns = 0;  ///< bit i: the field had the column of row i
    GeometryStamp stamp;        ///< of the mesh that the field was computed from
    /// A hash of the attributes' values. When a file is reloaded, MeshLab keeps the record and, in
    /// whatever order edits have left them, the values, or empties them.
    std::uint64_t content = 0;
    laplacian_lines::PrecomputeOptions options;
    laplacian_lines::FieldScale scale;
    laplacian_lines::MeshReport report;
};

enum class FieldStatus {
    Current,
    Missing,    ///< never computed, or MeshLab has dropped or mixed up part of it
    Stale,      ///< the mesh has changed since
    WrongType,  ///< somebody else's attribute has one of the names
};

/// For the log: what a status means, as a clause that follows "the mesh has ".
const char* describe(FieldStatus status);

/// Names of the per-vertex attributes that hold a field, separated by commas.
QString fieldAttributeNames(const laplacian_lines::Field& field);

/// Whether the mesh carries a field that belongs to it. `now` is geometryStamp(mesh).
FieldStatus fieldStatus(const CMeshO& mesh, const GeometryStamp& now);

/// The record of a mesh, if it has one that this build understands.
std::optional<FieldRecord> readFieldRecord(const CMeshO& mesh);

/// The field by live index (see mesh_conversion.h), empty unless fieldStatus() is Current.
std::optional<laplacian_lines::Field> readField(const CMeshO& mesh, const GeometryStamp& now);

/// Stores a field that has one entry per live vertex. Attributes of the same name and another type
/// are replaced, those of columns that the field does not have are removed. Deleted vertices get
/// zeros. The record is written last: if memory runs out on the
/// way the mesh has no field rather than half of one.
/// @throws laplacian_lines::Error(FieldMismatch), std::bad_alloc
void writeField(CMeshO& mesh, const laplacian_lines::Field& field,
                const laplacian_lines::PrecomputeOptions& options, const GeometryStamp& stamp);

}  // namespace meshlab_host
