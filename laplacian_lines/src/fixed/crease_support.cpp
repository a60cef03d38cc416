// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_criteria.h"

#include <algorithm>

#include "system/disjoint_sets.h"
#include "system/parallel.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3f;

constexpr float kGoesOn = 0.5f;  // least cosine between two edges of a chain
// Cosine of 10 degrees: what leaves a certain edge at less is a side of a sliver along it.
constexpr float kSliver = 0.985f;
constexpr float kLeastStrong = 0.5f;  // of the length

class SupportedCreases {
public:
    explicit SupportedCreases(const std::vector<PossibleCrease>& edges)
        : edges_(edges), kept_(edges.size(), 1), runs_out_(edges.size(), 0), places_(edges.size()) {
        std::vector<std::uint64_t> ends;  // by vertex, edge and end
        for (std::uint64_t i = 0; i < edges.size(); ++i)
            for (const unsigned end : {0u, 1u})
                ends.push_back(std::uint64_t(edges[i].vertices[end]) << 32 | i << 1 | end);
        std::sort(ends.begin(), ends.end());
        for (std::size_t k = 0; k < ends.size(); ++k) {
            if (k == 0 || ends[k] >> 32 != ends[k - 1] >> 32) begins_.push_back(std::uint32_t(k));
            const auto i = std::uint32_t(ends[k]) >> 1;
            at_.push_back(i);
            places_[i][ends[k] & 1] = std::uint32_t(begins_.size() - 1);
        }
        begins_.push_back(std::uint32_t(ends.size()));
    }

    std::vector<std::uint8_t> run(bool is_made) {
        drop_unclear();
        if (is_made) find_running_out();
        drop_loose();
        drop_doubtful();
        return std::move(kept_);
    }

private:
    struct Edges {
        const std::uint32_t *first, *last;
        const std::uint32_t* begin() const { return first; }
        const std::uint32_t* end() const { return last; }
        std::size_t size() const { return std::size_t(last - first); }
    };
    /// Those at an end of an edge, itself among them.
    Edges edges_at(std::uint32_t i, int end) const {
        const std::uint32_t place = places_[i][std::size_t(end)];
        return {&at_[begins_[place]], at_.data() + begins_[place + 1]};
    }

    /// Calls visit(number, cosine) for each other edge at an end of one; 1: it goes straight on.
    template <class Visit>
    void for_each_at(std::uint32_t i, int end, const Visit& visit) const {
        const PossibleCrease& edge = edges_[i];
        const Vector3f& here = edge.positions[end];
        const Vector3f direction = unit(here - edge.positions[1 - end]);
        for (const std::uint32_t o : edges_at(i, end)) {
            if (o == i) continue;
            const PossibleCrease& other = edges_[o];
            const int begin = other.vertices[0] == edge.vertices[end] ? 0 : 1;
            visit(o, dot(direction, unit(other.positions[1 - begin] - here)));
        }
    }

    /// All but gaps of one edge in chains that are clear.
    void drop_unclear() {
        for_each_element(edges_.size(), [&](std::size_t e) {
            const auto i = std::uint32_t(e);
            if (!edges_[i].is_unclear) return;
            bool closes_gap = true;
            for (int end = 0; end < 2; ++end) {
                bool goes_on = false;
                for_each_at(i, end, [&](std::uint32_t o, float cosine) {
                    goes_on = goes_on || (!edges_[o].is_unclear && cosine >= kGoesOn);
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
            if (edges_[i].is_certain) open.push_back(i);
        while (!open.empty()) {
            const std::uint32_t i = open.back();
            open.pop_back();
            for (int end = 0; end < 2; ++end) {
                const bool is_only_strong = strong_others(i, end) == 1;
                const bool is_only = edges_at(i, end).size() == 2;
                for_each_at(i, end, [&](std::uint32_t o, float cosine) {
                    const PossibleCrease& other = edges_[o];
                    if (runs_out_[o] || other.is_certain || other.angle >= edges_[i].angle) return;
                    const bool leads_on =
                        other.is_strong ? is_only_strong : is_only && !edges_[i].is_certain;
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
            count += edges_[o].is_certain || edges_[o].is_strong;
        });
        return count;
    }

    /// Edges with a loose end, and again those that lose theirs by that.
    void drop_loose() {
        const auto is_loose = [&](std::uint32_t i) {
            return kept_[i] && !edges_[i].is_certain && !is_held(i);
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
        bool certain = false, sliver = false, ahead = false;
        bool holds() const { return !sliver && (certain || ahead || others > 1); }
    };

    Around look_around(std::uint32_t i, int end) const {
        Around around;
        for_each_at(i, end, [&](std::uint32_t o, float cosine) {
            if (!kept_[o]) return;
            ++around.others;
            around.certain = around.certain || edges_[o].is_certain;
            around.sliver = around.sliver || (edges_[o].is_certain && cosine < -kSliver);
            around.ahead = around.ahead || cosine >= kGoesOn;
        });
        return around;
    }

    /// Whether both ends are where a crease goes on, where three meet or at an edge that is
    /// certain, or the edge is one at which a crease runs out.
    bool is_held(std::uint32_t i) const {
        const Around a = look_around(i, 0), b = look_around(i, 1);
        return (a.holds() && b.holds()) || (runs_out_[i] && !a.sliver && !b.sliver);
    }

    void drop_doubtful() {
        DisjointSets nets(begins_.size());
        const auto is_open = [&](std::uint32_t i) {
            return kept_[i] && !edges_[i].is_certain && !runs_out_[i];
        };
        for (std::uint32_t i = 0; i < edges_.size(); ++i)
            if (is_open(i)) nets.unite(places_[i][0], places_[i][1]);
        std::vector<float> all(begins_.size()), strong(begins_.size());
        const auto net_of = [&](std::uint32_t i) { return nets.root(places_[i][0]); };
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            if (!is_open(i)) continue;
            all[net_of(i)] += edges_[i].length();
            if (edges_[i].is_strong) strong[net_of(i)] += edges_[i].length();
        }
        for (std::uint32_t i = 0; i < edges_.size(); ++i)
            if (is_open(i) && strong[net_of(i)] < kLeastStrong * all[net_of(i)]) kept_[i] = 0;
    }

    const std::vector<PossibleCrease>& edges_;
    std::vector<std::uint8_t> kept_, runs_out_;
    std::vector<std::array<std::uint32_t, 2>> places_;  // numbers of the vertices
    std::vector<std::uint32_t> at_, begins_;            // edges by place; where a place's begin
};

}  // namespace

std::vector<std::uint8_t> find_supported(const std::vector<PossibleCrease>& edges, bool is_made) {
    return SupportedCreases(edges).run(is_made);
}

}  // namespace laplacian_lines
