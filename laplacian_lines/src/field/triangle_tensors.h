// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace laplacian_lines {

/// Triangles fitted together, one per lane. Unused lanes may hold anything.
struct TriangleBatch {
    static constexpr int kSize = 8;
    alignas(64) double positions[3][3][kSize];  ///< by corner and axis
    alignas(64) double normals[3][3][kSize];    ///< unit, of the vertices
};

/// Each triangle's curvature tensor, turned into the plane of each corner's normal.
struct TensorBatch {
    enum { kXX, kYY, kZZ, kYZ, kXZ, kXY, kEntries };
    /// For the tensor of a lane to be added at a corner.
    bool has(int corner, int lane) const {
        return cosines[corner][lane] > kLeastCosine && std::isfinite(sums[lane]);
    }

    alignas(64) double weights[TriangleBatch::kSize];               ///< twice the area
    alignas(64) double tensors[3][kEntries][TriangleBatch::kSize];  ///< times the weight
    /// Not finite for slivers whose fit has no solution.
    alignas(64) double sums[TriangleBatch::kSize];
    /// Between the triangle's normal and the corner's: opposite ones have no shortest turn.
    alignas(64) double cosines[3][TriangleBatch::kSize];
    static constexpr double kLeastCosine = -0.999;
};

/// See simd_sets.h.
struct TensorLoops {
    /// The symmetric tensor in each triangle's plane that best maps its edges to the changes of the
    /// normals along them: S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on
    /// Triangle Meshes", 3DPVT 2004, section 3.
    void (*fit)(const TriangleBatch& triangles, TensorBatch& tensors);
};

}  // namespace laplacian_lines
