// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/horizon.h"

#include <algorithm>

#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

class HorizonTracer {
public:
    HorizonTracer(const CoarseHorizon& horizon, std::vector<JoinedStrip>& strips,
                  const std::vector<OpenEnd>& open_ends, HorizonMemory& memory)
        : horizon_(horizon),
          strips_(strips),
          open_ends_(open_ends),
          m_(memory),
          vertex_count_(std::uint32_t(horizon.positions.size())) {}

    void run(const LocalEye& eye) {
        is_outside_ = !may_be_within(eye);
        horizon_.planes.evaluate(eye.eye, eye.w, m_.triangle_facing);
        horizon_.facing.evaluate(eye.eye, eye.w, m_.vertex_facing);
        collect_segments();
        link_segments();
        trace_chains();
        append_strips();
    }

private:
    bool faces(std::uint32_t triangle) const { return m_.triangle_facing[triangle] >= 0; }

    void add(std::uint32_t from, std::uint32_t to, bool is_hollow = false) {
        m_.segments.push_back({{from, to}, is_hollow});
    }

    void collect_segments() {
        m_.segments.clear();
        for (const CoarseHorizon::Edge& edge : horizon_.edges)
            if (faces(edge.triangles[0]) != (faces(edge.triangles[1]) != edge.is_reversed))
                add(edge.vertices[0], edge.vertices[1], edge.is_hollow && is_outside_);
        std::uint32_t open = 0;  // both are in the order of the edges' numbers
        for (const CoarseHorizon::OuterEdge& edge : horizon_.outer_edges) {
            while (open < open_ends_.size() && open_ends_[open].edge < edge.number)
                ++open;
            const bool ends_here = open < open_ends_.size() && open_ends_[open].edge == edge.number;
            add_outer(edge, ends_here ? vertex_count_ + open : kNoEnd);
        }
    }

    /// What is between a triangle's plane and a smooth surface, on which a contour may come to the
    /// edge at `crossing`. Whether it does is not asked again: signs near zero are uncertain.
    void add_outer(const CoarseHorizon::OuterEdge& edge, std::uint32_t crossing) {
        const float sign = faces(edge.triangle) ? 1.f : -1.f;
        const float a = sign * m_.vertex_facing[edge.vertices[0]];
        const float b = sign * m_.vertex_facing[edge.vertices[1]];
        if (crossing != kNoEnd)
            add(crossing, edge.vertices[a < b ? 0 : 1]);
        else if (a + b < 0)
            add(edge.vertices[0], edge.vertices[1]);
    }

    std::uint32_t end_of(std::uint32_t half) const { return m_.segments[half / 2].ends[half % 2]; }

    Eigen::Vector3f position(std::uint32_t end) const {
        if (end < vertex_count_) return horizon_.positions[end];
        return Eigen::Map<const Eigen::Vector3f>(open_point(end).position);
    }
    const StripPoint& open_point(std::uint32_t end) const {
        const std::uint32_t strip_end = open_ends_[end - vertex_count_].end;
        const JoinedStrip& strip = strips_[strip_end / 2];
        return strip.points[strip_end % 2 == 0 ? 0 : strip.count - 1];
    }
    /// From where a half begins.
    Eigen::Vector3f direction(std::uint32_t half) const {
        return (position(end_of(half ^ 1)) - position(end_of(half))).stableNormalized();
    }

    void link_segments() {
        const auto halves = std::uint32_t(2 * m_.segments.size());
        m_.links.assign(halves, kNoEnd);
        m_.next_at_end.resize(halves);
        const std::size_t ends = vertex_count_ + open_ends_.size();
        if (m_.in_use) m_.first_at_end.clear();
        if (m_.first_at_end.size() < ends) m_.first_at_end.resize(ends, kNoEnd);
        m_.in_use = true;
        for (std::uint32_t half = 0; half < halves; ++half) {
            std::uint32_t& first = m_.first_at_end[end_of(half)];
            m_.next_at_end[half] = first;
            first = half;
        }
        for (std::uint32_t half = 0; half < halves; ++half) {
            std::uint32_t& first = m_.first_at_end[end_of(half)];
            if (first != kNoEnd) link_all(first);
            first = kNoEnd;
        }
        m_.in_use = false;
    }

    /// Links the halves of an end in pairs, each with what goes on most straight.
    void link_all(std::uint32_t first) {
        const std::uint32_t second = m_.next_at_end[first];
        if (second != kNoEnd && m_.next_at_end[second] == kNoEnd) return link(first, second);
        for (std::uint32_t half = first; half != kNoEnd; half = m_.next_at_end[half]) {
            if (m_.links[half] != kNoEnd) continue;
            const std::uint32_t best = straightest(half);
            if (best != kNoEnd) link(half, best);
        }
    }

    void link(std::uint32_t half, std::uint32_t other) {
        m_.links[half] = other;
        m_.links[other] = half;
    }

    std::uint32_t straightest(std::uint32_t half) const {
        std::uint32_t best = kNoEnd;
        float least = 2;
        for (std::uint32_t i = m_.next_at_end[half]; i != kNoEnd; i = m_.next_at_end[i]) {
            if (m_.links[i] != kNoEnd) continue;
            const float cosine = dot(direction(half), direction(i));
            if (!(cosine < least)) continue;
            least = cosine;
            best = i;
        }
        return best;
    }

    void trace_chains() {
        m_.points.clear();
        m_.chains.clear();
        m_.visited.assign(m_.segments.size(), 0);
        for_each_chain(
            std::uint32_t(m_.segments.size()),
            [this](std::uint32_t half) { return m_.links[half]; },
            [this](std::uint32_t half) { trace(half); });
    }

    void trace(std::uint32_t start) {
        if (m_.visited[start / 2]) return;
        HorizonMemory::Chain chain{std::uint32_t(m_.points.size()), 1, {end_of(start), 0}, false};
        add_point(end_of(start));
        chain.closed = follow_chain(
            start, [this](std::uint32_t half) { return m_.links[half]; },
            [&](std::uint32_t half) {
                m_.visited[half / 2] = 1;
                chain.ends[1] = end_of(half ^ 1);
                add_point(chain.ends[1]);
                ++chain.point_count;
                if (m_.segments[half / 2].is_hollow) mark_hollow();
            });
        m_.chains.push_back(chain);
    }

    void add_point(std::uint32_t end) {
        StripPoint point{};
        point.opacity = 1;
        if (end >= vertex_count_) point = open_point(end);
        Eigen::Map<Eigen::Vector3f>(point.position) = position(end);
        point.slope = kExactSegment;
        m_.points.push_back(point);
    }

    /// Both ends of the last segment: what hides a contour there hides what is between two such,
    /// too.
    void mark_hollow() {
        for (auto point = m_.points.end() - 2; point != m_.points.end(); ++point)
            if (point->gradient == 0) point->gradient = -0.f;
    }

    void append_strips() {
        for (const HorizonMemory::Chain& chain : m_.chains) {
            const auto own = 2 * std::uint32_t(strips_.size());
            const StripPoint* points = m_.points.data() + chain.first_point;
            strips_.push_back({points, chain.point_count, 0, 0, 0, 0, true});
            measure(chain, strips_.back());
            for (const std::uint32_t side : {0u, 1u})
                if (chain.closed)
                    strips_.back().links[side] = (own + side) ^ 1;
                else if (chain.ends[side] >= vertex_count_)
                    join(own + side, open_ends_[chain.ends[side] - vertex_count_].end);
        }
    }

    void join(std::uint32_t end, std::uint32_t other) {
        strips_[end / 2].links[end % 2] = other;
        strips_[other / 2].links[other % 2] = end;
    }

    /// Adds up what rules on whole lines look at.
    void measure(const HorizonMemory::Chain& chain, JoinedStrip& strip) const {
        const StripPoint* points = m_.points.data() + chain.first_point;
        const auto position = [&](std::uint32_t i) {
            return Eigen::Map<const Eigen::Vector3f>(points[i].position);
        };
        for (std::uint32_t i = 1; i < chain.point_count; ++i) {
            const float length = length_of(position(i) - position(i - 1));
            strip.length += length;
            strip.strength += (points[i - 1].gradient + points[i].gradient) / 2 * length;
        }
    }

    const CoarseHorizon& horizon_;
    std::vector<JoinedStrip>& strips_;
    const std::vector<OpenEnd>& open_ends_;
    HorizonMemory& m_;
    bool is_outside_ = true;
    const std::uint32_t vertex_count_;
};

}  // namespace

void append_horizon(const CoarseHorizon& horizon, const LocalEye& eye, unsigned kind,
                    JoiningMemory& joining, HorizonMemory& memory) {
    std::sort(joining.open_ends.begin(), joining.open_ends.end(),
              [](const OpenEnd& a, const OpenEnd& b) { return a.edge < b.edge; });
    HorizonTracer(horizon, joining.strips[kind], joining.open_ends, memory).run(eye);
}

}  // namespace laplacian_lines
