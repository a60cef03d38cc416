// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/progress.h"
#include "meshlab_host/field_attributes.h"

namespace meshlab_host {

/// What decides the field of a mesh. Two meshes with equal keys have the same one, whatever layer
/// they are in, but for its derivatives, which may be there or not.
struct FieldKey {
    GeometryStamp stamp;
    std::vector<double> options;  ///< of the precomputation, as numbers

    bool operator<(const FieldKey& other) const;
};

/// Where the field of a mesh comes from: its own attributes if they are current, otherwise a
/// computation with the default options.
struct FieldSource {
    FieldKey key;
    FieldStatus status;
    laplacian_lines::PrecomputeOptions options;
};
FieldSource fieldSource(const CMeshO& mesh);
/// The same field with its curvature derivatives.
FieldSource withDerivatives(FieldSource source);

/// The field from there, by live index. Computing takes seconds for a million triangles and is told
/// to `say`. The mesh is not changed; `triangles` is toTriangleMesh() of it.
/// @throws laplacian_lines::Error, std::bad_alloc
laplacian_lines::Field demandField(const CMeshO& mesh,
                                   const laplacian_lines::TriangleMesh& triangles,
                                   const QString& mesh_name, const FieldSource& source,
                                   const std::function<void(const QString&)>& say,
                                   const laplacian_lines::Progress& progress = {});

/// Computes a field's curvature derivatives, if it has none yet.
/// @throws laplacian_lines::Error, std::bad_alloc
void demandDerivatives(const laplacian_lines::TriangleMesh& triangles,
                       laplacian_lines::Field& field,
                       const laplacian_lines::Progress& progress = {});

}  // namespace meshlab_host
