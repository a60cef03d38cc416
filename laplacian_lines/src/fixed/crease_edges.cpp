// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_tracing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fixed/crease_criteria.h"
#include "mesh/flat_faces.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr float kDegrees = 57.29577951308232f;
// Less is not called a crease: two faces that were made to be one meet at angles as large.
constexpr float kLeastCreaseAngle = 3;  // degrees
// For scans, where anything duller may be noise.
constexpr float kLeastMeasuredAngle = 20;  // degrees
// Shares of the edge's angle that are not explained. Half is between a facet, of which all is, and
// an edge between flat faces, of which nothing is; what goes on from there may be weaker.
constexpr float kStrong = 0.5f, kWeak = 0.25f;
// More than half of the edges are flat on a rough mesh where it has voxels' terraces.
constexpr double kTerracesShare = 0.5;
constexpr std::size_t kEdgesAtATime = 256;

float cosine_of(float degrees) {
    return std::cos(degrees / kDegrees);
}

/// A bent edge with the vertices at its ends.
struct Candidate {
    TriangleSide side;
    std::uint32_t vertices[2];
    float angle;  ///< degrees
};

/// None: noise. Facet: shown only by styles with an angle as small. Unclear: strong, but a side
/// that is neither flat nor even cannot tell.
enum class Verdict : std::uint8_t { None, Facet, Unclear, Weak, Strong, Certain };

class CreaseFinder {
public:
    CreaseFinder(const ExtractorData& data, float least_angle)
        : least_angle_(least_angle),
          graph_(build_triangle_graph(data)),
          placed_(place_clusters(data)),
          is_rough_(data.is_rough),
          is_made_(was_made(is_rough_)) {}

    std::vector<CreaseEdge> run() const {
        if (is_rough_ && !is_made_) return {};  // edges are those of noise or of voxels
        const std::vector<Candidate> candidates = find_candidates();
        std::vector<Verdict> verdicts(candidates.size());
        const std::size_t parts = (candidates.size() + kEdgesAtATime - 1) / kEdgesAtATime;
        in_parallel(parts, [&](std::size_t part) {
            const std::size_t begin = part * kEdgesAtATime;
            const std::size_t end = std::min(candidates.size(), begin + kEdgesAtATime);
            for (std::size_t i = begin; i < end; ++i)
                verdicts[i] = judge(candidates[i]);
        });
        return supported(candidates, verdicts);
    }

private:
    /// Calls visit(triangle, side, cosine) for each edge of a cluster's triangles once.
    template <class Visit>
    void for_each_edge(std::size_t c, const Visit& visit) const {
        for (unsigned t = 0; t < placed_[c].cluster->triangle_count; ++t) {
            const std::uint32_t triangle = placed_[c].first_triangle + t;
            const TriangleGraph::Node& node = graph_.triangles[triangle];
            for (unsigned k = 0; k < 3; ++k) {
                const std::uint32_t next = node.neighbours[k];
                if (next == TriangleGraph::kNone || next <= triangle) continue;
                if (node.normal.isZero(0) || graph_.triangles[next].normal.isZero(0)) continue;
                visit(t, k, graph_.cosine_across(triangle, k));
            }
        }
    }

    /// Faces of large triangles count for what they are: lofts have few that are flat. Notes in the
    /// graph how often a scan was subdivided.
    bool was_made(bool is_rough) {
        struct Counts {
            double edges = 0, flat_edges = 0, area = 0, flat_area = 0;
        };
        std::vector<Counts> of_cluster(placed_.size());
        in_parallel(placed_.size(), [&](std::size_t c) {
            Counts& counts = of_cluster[c];
            for_each_edge(c, [&](unsigned, unsigned, float cosine) {
                ++counts.edges;
                counts.flat_edges += cosine >= flat_;
            });
            for (unsigned t = 0; t < placed_[c].cluster->triangle_count; ++t) {
                const std::uint32_t triangle = placed_[c].first_triangle + t;
                const double area = double(graph_.triangles[triangle].area);
                counts.area += area;
                if (graph_.goes_on_flat(triangle, flat_)) counts.flat_area += area;
            }
        });
        Counts sum;
        for (const Counts& some : of_cluster) {
            sum.edges += some.edges;
            sum.flat_edges += some.flat_edges;
            sum.area += some.area;
            sum.flat_area += some.flat_area;
        }
        if (sum.flat_area < kMadeShare * sum.area ||
            (is_rough && sum.flat_edges > kTerracesShare * sum.edges))
            return false;
        const TriangularFaces faces = find_triangular_faces(graph_, flat_);
        if ((1 - faces.share) * sum.flat_area >= kMadeShare * sum.area) return true;
        graph_.subdivision = std::uint32_t(std::lround(faces.parts));
        return false;
    }

    std::vector<Candidate> find_candidates() const {
        const float bent = cosine_of(is_made_ ? kLeastCreaseAngle : kLeastMeasuredAngle);
        std::vector<std::vector<Candidate>> of_cluster(placed_.size());
        in_parallel(placed_.size(), [&](std::size_t c) {
            for_each_edge(c, [&](unsigned t, unsigned k, float cosine) {
                if (cosine > bent) return;
                const auto& corners = placed_[c].triangle(t).corners;
                of_cluster[c].push_back(
                    {{placed_[c].first_triangle + t, k},
                     {placed_[c].vertices[corners[k]], placed_[c].vertices[corners[(k + 1) % 3]]},
                     float(std::acos(std::max(double(cosine), -1.))) * kDegrees});
            });
        });
        std::vector<Candidate> all;
        for (const std::vector<Candidate>& some : of_cluster)
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }

    Verdict judge(const Candidate& edge) const {
        const auto [triangle, k] = edge.side;
        if (!is_made_ && !is_edge_of_form(graph_, {triangle, k, edge.angle})) return Verdict::None;
        if (edge.angle >= kEdgeAngle) return Verdict::Certain;
        if (is_mere_diagonal(graph_, edge.side)) return Verdict::Facet;
        const CreaseJump jump = crease_jump(graph_, edge.side, signed_angle(graph_, edge.side));
        if (jump.degrees <= std::max(kLeastCreaseAngle, kWeak * edge.angle)) return Verdict::Facet;
        const bool is_strong = jump.degrees > kStrong * edge.angle;
        if (!jump.is_clear) return is_strong ? Verdict::Unclear : Verdict::Facet;
        return is_strong ? Verdict::Strong : Verdict::Weak;
    }

    std::vector<CreaseEdge> supported(const std::vector<Candidate>& candidates,
                                      const std::vector<Verdict>& verdicts) const {
        std::vector<std::uint32_t> numbers;  // of candidates
        std::vector<PossibleCrease> possible;
        for (std::uint32_t i = 0; i < candidates.size(); ++i) {
            if (verdicts[i] < Verdict::Unclear) continue;
            const CreaseEdge edge = make_edge(candidates[i], 0);
            numbers.push_back(i);
            possible.push_back({{edge.vertices[0], edge.vertices[1]},
                                {edge.positions[0], edge.positions[1]},
                                edge.angle,
                                verdicts[i] == Verdict::Certain,
                                verdicts[i] == Verdict::Strong,
                                verdicts[i] == Verdict::Unclear});
        }
        std::vector<float> shown(candidates.size());
        for (std::uint32_t i = 0; i < candidates.size(); ++i)
            shown[i] = verdicts[i] == Verdict::None ? 0 : candidates[i].angle;
        const std::vector<std::uint8_t> kept = find_supported(possible, is_made_);
        for (std::size_t n = 0; n < numbers.size(); ++n)
            if (kept[n]) shown[numbers[n]] = std::max(kEdgeAngle, candidates[numbers[n]].angle);
        std::vector<CreaseEdge> edges;
        for (std::size_t i = 0; i < candidates.size(); ++i)
            if (shown[i] > 0 && shown[i] >= least_angle_)
                edges.push_back(make_edge(candidates[i], shown[i]));
        return edges;
    }

    CreaseEdge make_edge(const Candidate& candidate, float shown_up_to) const {
        const auto [triangle, side] = candidate.side;
        const TriangleGraph::Node& node = graph_.triangles[triangle];
        const auto facet = [&](std::uint32_t t) {
            return graph_.goes_on_flat(t, flat_) ? TriangleGraph::kNone : t;
        };
        return {
            {candidate.vertices[0], candidate.vertices[1]},
            {graph_.position(triangle, side), graph_.position(triangle, (side + 1) % 3)},
            {node.normal, node.sign_across(side) * graph_.triangles[node.neighbours[side]].normal},
            {facet(triangle), facet(node.neighbours[side])},
            candidate.angle,
            shown_up_to};
    }

    const float least_angle_;
    const float flat_ = cosine_of(kFlat);
    TriangleGraph graph_;
    const std::vector<PlacedCluster> placed_;
    const bool is_rough_, is_made_;
};

}  // namespace

std::vector<CreaseEdge> find_crease_edges(const ExtractorData& data, float least_angle) {
    return CreaseFinder(data, least_angle).run();
}

}  // namespace laplacian_lines
