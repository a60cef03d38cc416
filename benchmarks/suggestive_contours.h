// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laplacian_lines/view.h"
#include "plain_mesh.h"
#include "vertex_curvature.h"

namespace benchmarks {

/// What the extractor is compared with: suggestive contours as loose segments, not traced. They
/// are the zeros of the radial curvature κ_r, the normal curvature in the direction w towards the
/// eye along the surface, where it grows towards the eye.
/// Sources: D. DeCarlo et al., "Suggestive Contours for Conveying Shape", SIGGRAPH 2003, and
/// "Interactive Rendering of Suggestive Contours with Temporal Coherence", NPAR 2004, for D_w κ_r.
class SuggestiveContours {
public:
    /// Computes what does not depend on the view. Both have to outlive this object; the normals
    /// are unit and outward.
    SuggestiveContours(const PlainMesh& mesh, const std::vector<Eigen::Vector3f>& normals);

    /// Replaces `segments` by pairs of points: where the surface faces the eye and D_w κ_r is
    /// above a tenth of the median of (κ₁² + κ₂²)/2.
    void extract(const laplacian_lines::View& view, std::vector<Eigen::Vector3f>& segments);

    /// What a view says of a vertex.
    struct Seen {
        float facing;           ///< n·l, a length
        float curvature;        ///< κ_r, 1/length
        float above_threshold;  ///< D_w κ_r less the threshold, 1/length²
    };
    static Seen look(const Eigen::Vector3f& to_eye, const Eigen::Vector3f& normal,
                     const VertexCurvature& curvature, float threshold);

private:
    void add_segment(const laplacian_lines::Triangle& t,
                     std::vector<Eigen::Vector3f>& segments) const;

    const PlainMesh& mesh_;
    const std::vector<Eigen::Vector3f>& normals_;
    const std::vector<VertexCurvature> curvatures_;
    float threshold_;
    std::vector<Seen> seen_;
};

}  // namespace benchmarks
