// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_edges.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "system/disjoint_sets.h"
#include "system/parallel.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr float kGoesOn = 0.5f;       // least cosine between two edges of a chain
constexpr float kLeastStrong = 0.5f;  // of the length

class SupportedCreases {
public:
    explicit SupportedCreases(const std::vector<const CreaseEdge*>& edges)
        : edges_(edges), kept_(edges.size(), 1), runs_out_(edges.size(), 0), places_(edges.size()) {
        std::unordered_map<std::uint32_t, std::uint32_t> places;  // by vertex
        for (std::uint32_t i = 0; i < edges.size(); ++i)
            for (const unsigned end : {0u, 1u}) {
                const auto [place, is_new] =
                    places.try_emplace(edges[i]->vertices[end], std::uint32_t(at_.size()));
                if (is_new) at_.emplace_back();
                places_[i][end] = place->second;
                at_[place->second].push_back(i);
            }
    }

    std::vector<std::uint8_t> run(bool is_made) {
        drop_unclear();
        if (is_made) find_running_out();
        drop_loose();
        drop_doubtful();
        return std::move(kept_);
    }

private:
    /// Those at an end of an edge, itself among them.
    const std::vector<std::uint32_t>& edges_at(std::uint32_t i, int end) const {
        return at_[places_[i][std::size_t(end)]];
    }

    /// Calls visit(number, cosine) for each other edge at an end of one; 1: it goes straight on.
    template <class Visit>
    void for_each_at(std::uint32_t i, int end, const Visit& visit) const {
        const CreaseEdge& edge = *edges_[i];
        const Vector3f& here = edge.positions[end];
        const Vector3f direction = unit(here - edge.positions[1 - end]);
        for (const std::uint32_t o : edges_at(i, end)) {
            if (o == i) continue;
            const CreaseEdge& other = *edges_[o];
            const int begin = other.vertices[0] == edge.vertices[end] ? 0 : 1;
            visit(o, dot(direction, unit(other.positions[1 - begin] - here)));
        }
    }

    /// All but gaps of one edge in chains that are clear.
    void drop_unclear() {
        for_each_element(edges_.size(), [&](std::size_t e) {
            const auto i = std::uint32_t(e);
            if (!edges_[i]->is_unclear()) return;
            bool closes_gap = true;
            for (int end = 0; end < 2; ++end) {
                bool goes_on = false;
                for_each_at(i, end, [&](std::uint32_t o, float cosine) {
                    goes_on = goes_on || (!edges_[o]->is_unclear() && cosine >= kGoesOn);
                });
                closes_gap = closes_gap && goes_on;
            }
            kept_[i] = closes_gap;
        });
    }

    /// From certain edges on those of ever smaller angles, each the only strong one that goes on
    /// there; after strong ones also weak ones which nothing else meets.
    void find_running_out() {
        std::vector<std::uint32_t> open;
        for (std::uint32_t i = 0; i < edges_.size(); ++i)
            if (edges_[i]->is_certain()) open.push_back(i);
        while (!open.empty()) {
            const std::uint32_t i = open.back();
            open.pop_back();
            for (int end = 0; end < 2; ++end) {
                const bool is_only_strong = strong_others(i, end) == 1;
                const bool is_only = edges_at(i, end).size() == 2;
                for_each_at(i, end, [&](std::uint32_t o, float cosine) {
                    const CreaseEdge& other = *edges_[o];
                    if (runs_out_[o] || other.is_certain() || other.angle >= edges_[i]->angle)
                        return;
                    const bool leads_on =
                        other.is_strong() ? is_only_strong : is_only && !edges_[i]->is_certain();
                    if (!leads_on || cosine < kGoesOn) return;
                    runs_out_[o] = 1;
                    open.push_back(o);
                });
            }
        }
    }

    int strong_others(std::uint32_t i, int end) const {
        int count = 0;
        for_each_at(i, end, [&](std::uint32_t o, float) {
            count += edges_[o]->is_certain() || edges_[o]->is_strong();
        });
        return count;
    }

    /// Edges with a loose end, and again those that lose theirs by that.
    void drop_loose() {
        const auto is_loose = [&](std::uint32_t i) {
            return kept_[i] && !edges_[i]->is_certain() && !is_held(i);
        };
        auto open = collect<std::uint32_t>(edges_.size(),
                                           [&](std::uint32_t i, std::vector<std::uint32_t>& found) {
                                               if (is_loose(i)) found.push_back(i);
                                           });
        while (!open.empty()) {
            const std::uint32_t i = open.back();
            open.pop_back();
            if (!is_loose(i)) continue;
            kept_[i] = 0;
            for (const int end : {0, 1})
                open.insert(open.end(), edges_at(i, end).begin(), edges_at(i, end).end());
        }
    }

    /// What is at an end of an edge.
    struct Around {
        int others = 0;
        bool certain = false, ahead = false;
        bool holds() const { return certain || ahead || others > 1; }
    };

    Around look_around(std::uint32_t i, int end) const {
        Around around;
        for_each_at(i, end, [&](std::uint32_t o, float cosine) {
            if (!kept_[o]) return;
            ++around.others;
            around.certain = around.certain || edges_[o]->is_certain();
            around.ahead = around.ahead || cosine >= kGoesOn;
        });
        return around;
    }

    /// Whether both ends are where a crease goes on, where three meet or at an edge that is
    /// certain, or the edge is one at which a crease runs out.
    bool is_held(std::uint32_t i) const {
        return runs_out_[i] || (look_around(i, 0).holds() && look_around(i, 1).holds());
    }

    void drop_doubtful() {
        DisjointSets nets(at_.size());
        const auto is_open = [&](std::uint32_t i) {
            return kept_[i] && !edges_[i]->is_certain() && !runs_out_[i];
        };
        for (std::uint32_t i = 0; i < edges_.size(); ++i)
            if (is_open(i)) nets.unite(places_[i][0], places_[i][1]);
        std::vector<float> all(at_.size()), strong(at_.size());
        const auto net_of = [&](std::uint32_t i) { return nets.root(places_[i][0]); };
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            if (!is_open(i)) continue;
            all[net_of(i)] += edges_[i]->length();
            if (edges_[i]->is_strong()) strong[net_of(i)] += edges_[i]->length();
        }
        for (std::uint32_t i = 0; i < edges_.size(); ++i)
            if (is_open(i) && strong[net_of(i)] < kLeastStrong * all[net_of(i)]) kept_[i] = 0;
    }

    const std::vector<const CreaseEdge*>& edges_;
    std::vector<std::uint8_t> kept_, runs_out_;
    std::vector<std::array<std::uint32_t, 2>> places_;  // numbers of the vertices
    std::vector<std::vector<std::uint32_t>> at_;        // edges by place
};

}  // namespace

void drop_unsupported(std::vector<CreaseEdge>& edges, bool is_made) {
    std::vector<std::uint32_t> numbers;
    std::vector<const CreaseEdge*> possible;
    for (std::uint32_t i = 0; i < edges.size(); ++i)
        if (edges[i].verdict > CreaseEdge::Verdict::Facet) {
            numbers.push_back(i);
            possible.push_back(&edges[i]);
        }
    const std::vector<std::uint8_t> kept = SupportedCreases(possible).run(is_made);
    for (std::size_t n = 0; n < numbers.size(); ++n)
        if (!kept[n]) edges[numbers[n]].verdict = CreaseEdge::Verdict::Facet;
}

}  // namespace laplacian_lines
