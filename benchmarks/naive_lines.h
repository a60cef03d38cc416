// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

namespace benchmarks {

/// What the extractor is compared with: all zero crossings of Δn·l (or of n·l: contours) in one
/// loop over the triangles, as loose segments. Nothing is filtered or traced.
class NaiveLines {
public:
    NaiveLines(const laplacian_lines::TriangleMesh& mesh,
               const std::vector<Eigen::Vector3f>& vectors);

    /// Replaces `segments` by pairs of points.
    void extract(const laplacian_lines::View& view, std::vector<Eigen::Vector3f>& segments);

private:
    std::vector<Eigen::Vector3f> positions_, vectors_;
    std::vector<laplacian_lines::Triangle> triangles_;
    std::vector<float> values_;
};

}  // namespace benchmarks
