// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <functional>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/progress.h"
#include "meshlab_host/field_attributes.h"

namespace meshlab_host {

/// Identifies the field of a mesh: equal keys mean equal fields, in whatever layer, apart from
/// derivatives.
struct FieldKey {
    GeometryStamp stamp;
    std::vector<double> options;  ///< of the precomputation, as numbers

    bool operator<(const FieldKey& other) const;
};

/// Where a field comes from: the mesh's attributes if they are current and refined() leaves the
/// mesh as it is, else precompute() with their options, or the defaults.
struct FieldSource {
    FieldKey key;
    FieldStatus status;
    laplacian_lines::PrecomputeOptions options;
};
FieldSource field_source(const CMeshO& mesh);
FieldSource with_derivatives(FieldSource source);

/// Whether the mesh's attributes hold the field of `triangles`, its to_drawn_mesh().
bool is_stored(const CMeshO& mesh, const laplacian_lines::TriangleMesh& triangles,
               const FieldSource& source);

/// Reads the field or computes it, which takes seconds for a million triangles and is logged by
/// `say`. By live index. Does not change the mesh; `triangles` is its to_drawn_mesh().
/// @throws laplacian_lines::Error, std::bad_alloc
laplacian_lines::Field find_or_compute_field(const CMeshO& mesh,
                                             const laplacian_lines::TriangleMesh& triangles,
                                             const QString& mesh_name, const FieldSource& source,
                                             const std::function<void(const QString&)>& say,
                                             const laplacian_lines::Progress& progress = {});

/// Computes a field's derivatives if it has none. @throws laplacian_lines::Error, std::bad_alloc
void ensure_derivatives(const laplacian_lines::TriangleMesh& triangles,
                        laplacian_lines::Field& field,
                        const laplacian_lines::Progress& progress = {});

/// A line of the log per laplacian_lines::faults_of(), what to do about it in MeshLab's terms.
QStringList mesh_advice(const laplacian_lines::MeshReport& report);

}  // namespace meshlab_host
