// SPDX-License-Identifier: GPL-3.0-or-later
// An edge alone may be one of a bad triangle; those of a form meet others. In this order, since
// each step looks at what the ones before have kept:
//  1. Unclear edges go, except single ones between clear edges.
//  2. Creases that run out from a certain edge, as mitres of fillets do, are found: they may end in
//     nothing, and be weak.
//  3. Other edges with a loose end go, one after the other.
//  4. Of the rest, connected edges go of which less than half is strong.
#include "fixed/crease_edges.h"

#include <algorithm>
#include <unordered_map>

#include "system/disjoint_sets.h"
#include "system/parallel.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;
using Verdict = CreaseEdge::Verdict;

constexpr float kGoesOn = 0.5f;       // least cosine at which an edge goes on straight
constexpr float kLeastStrong = 0.5f;  // of the length: most of a net decides for all

class SupportedCreases {
public:
    explicit SupportedCreases(std::vector<CreaseEdge>& edges)
        : edges_(edges), runs_out_(edges.size(), 0) {
        for (std::uint32_t i = 0; i < edges.size(); ++i)
            if (is_kept(i))
                for (const std::uint32_t v : edges[i].vertices)
                    at_[v].push_back(i);
    }

    void run() {
        drop_unclear();
        find_running_out();
        drop_loose();
        drop_doubtful();
    }

private:
    bool is_kept(std::uint32_t i) const { return edges_[i].verdict > Verdict::Facet; }
    void drop(std::uint32_t i) { edges_[i].verdict = Verdict::Facet; }
    /// Whether a kept edge needs others: it is not certain, nor part of a crease that runs out.
    bool is_undecided(std::uint32_t i) const {
        return is_kept(i) && !edges_[i].is_certain() && !runs_out_[i];
    }

    /// Those at an end of an edge, itself and dropped ones among them.
    const std::vector<std::uint32_t>& edges_at(std::uint32_t i, int end) const {
        return at_.find(edges_[i].vertices[end])->second;
    }

    /// Calls visit(number, cosine) for each other kept edge at an end of one; 1: straight on.
    template <class Visit>
    void for_each_at(std::uint32_t i, int end, const Visit& visit) const {
        const CreaseEdge& edge = edges_[i];
        const Vector3f& here = edge.positions[end];
        const Vector3f direction = unit(here - edge.positions[1 - end]);
        for (const std::uint32_t o : edges_at(i, end)) {
            if (o == i || !is_kept(o)) continue;
            const CreaseEdge& other = edges_[o];
            const int begin = other.vertices[0] == edge.vertices[end] ? 0 : 1;
            visit(o, dot(direction, unit(other.positions[1 - begin] - here)));
        }
    }

    /// Drops unclear edges, unless clear ones go on straight at both ends.
    void drop_unclear() {
        const auto closes_gap = [&](std::uint32_t i) {
            bool goes_on[2] = {false, false};
            for (const int end : {0, 1})
                for_each_at(i, end, [&](std::uint32_t o, float cosine) {
                    goes_on[end] = goes_on[end] || (!edges_[o].is_unclear() && cosine >= kGoesOn);
                });
            return goes_on[0] && goes_on[1];
        };
        for (const std::uint32_t i : numbers_where(edges_.size(), [&](std::uint32_t i) {
                 return edges_[i].is_unclear() && !closes_gap(i);
             }))
            drop(i);
    }

    /// Follows creases that run out: from certain edges on, each straight on, and at its vertex the
    /// only strong or certain edge beside the one before; a weak or unclear one the only edge.
    void find_running_out() {
        std::vector<std::uint32_t> open;
        for (std::uint32_t i = 0; i < edges_.size(); ++i)
            if (edges_[i].is_certain()) open.push_back(i);
        while (!open.empty()) {
            const std::uint32_t i = open.back();
            open.pop_back();
            for (const int end : {0, 1}) {
                int others = 0, strong = 0;
                for_each_at(i, end, [&](std::uint32_t o, float) {
                    ++others;
                    strong += edges_[o].is_certain() || edges_[o].is_strong();
                });
                for_each_at(i, end, [&](std::uint32_t o, float cosine) {
                    const CreaseEdge& other = edges_[o];
                    if (runs_out_[o] || other.is_certain() || cosine < kGoesOn) return;
                    if ((other.is_strong() ? strong : others) != 1) return;
                    runs_out_[o] = 1;
                    open.push_back(o);
                });
            }
        }
    }

    /// Drops edges with a loose end until there are none.
    void drop_loose() {
        const auto is_loose = [&](std::uint32_t i) {
            return is_undecided(i) && !(is_held(i, 0) && is_held(i, 1));
        };
        auto open = numbers_where(edges_.size(), is_loose);
        while (!open.empty()) {
            const std::uint32_t i = open.back();
            open.pop_back();
            if (!is_loose(i)) continue;
            drop(i);
            for (const int end : {0, 1})
                open.insert(open.end(), edges_at(i, end).begin(), edges_at(i, end).end());
        }
    }

    /// Whether a crease continues at this end, three meet there, or one of them is certain.
    bool is_held(std::uint32_t i, int end) const {
        int others = 0;
        bool is_held = false;
        for_each_at(i, end, [&](std::uint32_t o, float cosine) {
            ++others;
            is_held = is_held || edges_[o].is_certain() || cosine >= kGoesOn;
        });
        return is_held || others > 1;
    }

    /// Drops connected nets of edges of which less than half is strong.
    void drop_doubtful() {
        DisjointSets nets(edges_.size());
        for (const auto& [vertex, edges] : at_) {
            const auto first = std::find_if(edges.begin(), edges.end(),
                                            [&](std::uint32_t i) { return is_undecided(i); });
            for (auto i = first; i != edges.end(); ++i)
                if (is_undecided(*i)) nets.unite(*first, *i);
        }
        std::vector<float> all(edges_.size()), strong(edges_.size());
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            if (!is_undecided(i)) continue;
            all[nets.root(i)] += edges_[i].length();
            if (edges_[i].is_strong()) strong[nets.root(i)] += edges_[i].length();
        }
        for (std::uint32_t i = 0; i < edges_.size(); ++i)
            if (is_undecided(i) && strong[nets.root(i)] < kLeastStrong * all[nets.root(i)]) drop(i);
    }

    std::vector<CreaseEdge>& edges_;
    std::vector<std::uint8_t> runs_out_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> at_;  // edges by vertex
};

}  // namespace

void drop_unsupported(std::vector<CreaseEdge>& edges) {
    SupportedCreases(edges).run();
}

}  // namespace laplacian_lines
