// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "helpers.h"
#include "laplacian_lines/precompute.h"

namespace helpers {

using namespace laplacian_lines;

/// On [−1, 1]² from +z: ΔI = slope · (x − offset), ∇I = (gradient, 0, 0). The line x = offset has
/// length 2 and ends at borders.
struct Synthetic {
    double gradient = -1;  ///< negative: an edge; positive: a phantom
    double slope = 1;
    double offset = 0.013;
    double facing = 1;       ///< n·z
    double kernel_size = 1;  ///< √h; no smoothing, so h_e = h and the line's slope is slope · √h³
    double trace = 0;        ///< of S

    static constexpr double kDiagonal = 2.8284271247461903;

    static const TriangleMesh& mesh() { return test_meshes::mesh_named("plane").mesh; }

    LineExtractor extractor() const {
        Field field = precompute(mesh());
        for (std::size_t v = 0; v < field.normals.size(); ++v) {
            field.laplacian_normals[v] = {0, 0, float(slope * (mesh().positions[v].x() - offset))};
            field.normals[v] = {0, float(std::sqrt(1 - facing * facing)), float(facing)};
            field.shape_operators[v] = {};
            field.shape_operators[v].xz = float(gradient);
            field.shape_operators[v].yy = float(trace);
        }
        field.scale.kernel_size = kernel_size;
        field.scale.normal_sigma = 0;
        return LineExtractor(mesh(), field);
    }

    static View above() { return View::orthographic(Eigen::Vector3d::UnitZ()); }
    LineSet lines(const LineStyle& style, const View& view = above()) const {
        return helpers::extract(extractor(), view, style);
    }
    bool is_drawn(const LineStyle& style) const { return !lines(style).lines.empty(); }
};

}  // namespace helpers
