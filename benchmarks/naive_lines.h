// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/view.h"
#include "plain_mesh.h"

namespace benchmarks {

/// What the extractor is compared with: all zero crossings of Δn·l (or of n·l: contours) in one
/// loop over the triangles, as loose segments. Nothing is filtered or traced.
class NaiveLines {
public:
    /// Both have to outlive this object. `vectors` are Δn, or n, of the vertices.
    NaiveLines(const PlainMesh& mesh, const std::vector<Eigen::Vector3f>& vectors);

    /// Replaces `segments` by pairs of points.
    void extract(const laplacian_lines::View& view, std::vector<Eigen::Vector3f>& segments);

private:
    const PlainMesh& mesh_;
    const std::vector<Eigen::Vector3f>& vectors_;
    std::vector<float> values_;
};

}  // namespace benchmarks
