// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_edges.h"

#include <algorithm>
#include <cmath>

#include "fixed/crease_surroundings.h"
#include "system/parallel.h"

namespace laplacian_lines {
namespace {

constexpr float kDegrees = 57.29577951308232f;
// Less is not called a crease, whatever the style asks for.
constexpr float kLeastCreaseAngle = 20;  // degrees
constexpr std::size_t kEdgesAtATime = 256;
/// A bent edge with the vertices at its ends.
struct Candidate {
    BentEdge bent;
    std::uint32_t vertices[2];
};

class CreaseFinder {
public:
    CreaseFinder(const ExtractorData& data, float least_angle)
        : least_angle_(least_angle),
          graph_(build_triangle_graph(data)),
          placed_(place_clusters(data)) {}

    std::vector<CreaseEdge> run() const {
        const std::vector<Candidate> candidates = find_candidates();
        std::vector<float> shown(candidates.size());
        const std::size_t parts = (candidates.size() + kEdgesAtATime - 1) / kEdgesAtATime;
        in_parallel<NoScratch>(parts, [&](std::size_t part, NoScratch&) {
            const std::size_t begin = part * kEdgesAtATime;
            const std::size_t end = std::min(candidates.size(), begin + kEdgesAtATime);
            for (std::size_t i = begin; i < end; ++i)
                shown[i] = shown_up_to(candidates[i].bent);
        });
        std::vector<CreaseEdge> edges;
        for (std::size_t i = 0; i < candidates.size(); ++i)
            if (shown[i] > 0) edges.push_back(make_edge(candidates[i], shown[i]));
        return edges;
    }

private:
    std::vector<Candidate> find_candidates() const {
        std::vector<std::vector<Candidate>> of_cluster(placed_.size());
        in_parallel<NoScratch>(placed_.size(), [&](std::size_t c, NoScratch&) {
            for (unsigned t = 0; t < placed_[c].cluster->triangle_count; ++t)
                add_candidates(c, t, of_cluster[c]);
        });
        std::vector<Candidate> all;
        for (const std::vector<Candidate>& some : of_cluster)
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }

    void add_candidates(std::size_t c, unsigned t, std::vector<Candidate>& candidates) const {
        static const float bent = std::cos(kLeastCreaseAngle / kDegrees);
        const std::uint32_t triangle = graph_.first[c] + t;
        const TriangleGraph::Node& node = graph_.triangles[triangle];
        for (unsigned k = 0; k < 3; ++k) {
            const std::uint32_t next = node.neighbours[k];
            if (next == TriangleGraph::kNone || next <= triangle) continue;
            const float cosine = graph_.cosine_across(triangle, k);
            if (cosine > bent || node.normal.isZero(0) || graph_.triangles[next].normal.isZero(0))
                continue;
            const std::uint8_t* corners = placed_[c].triangles[t].corners;
            candidates.push_back(
                {{triangle, k, std::acos(std::max(cosine, -1.f)) * kDegrees},
                 {placed_[c].vertices[corners[k]], placed_[c].vertices[corners[(k + 1) % 3]]}});
        }
    }

    /// 0: not at all.
    float shown_up_to(const BentEdge& edge) const {
        const bool alone = edge.angle < kEdgeAngle && is_bent_alone(graph_, edge);
        const float shown = alone ? kEdgeAngle : edge.angle;
        return shown >= least_angle_ && is_edge_of_form(graph_, edge) ? shown : 0;
    }

    CreaseEdge make_edge(const Candidate& candidate, float shown_up_to) const {
        const auto& [triangle, side, angle] = candidate.bent;
        const TriangleGraph::Node& node = graph_.triangles[triangle];
        return {
            {candidate.vertices[0], candidate.vertices[1]},
            {graph_.position(triangle, side), graph_.position(triangle, (side + 1) % 3)},
            {node.normal, node.sign_across(side) * graph_.triangles[node.neighbours[side]].normal},
            angle,
            shown_up_to};
    }

    const float least_angle_;
    const TriangleGraph graph_;
    const std::vector<PlacedCluster> placed_;
};

}  // namespace

std::vector<CreaseEdge> find_crease_edges(const ExtractorData& data, float least_angle) {
    return CreaseFinder(data, least_angle).run();
}

}  // namespace laplacian_lines
