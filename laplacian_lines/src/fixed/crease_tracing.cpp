// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/crease_tracing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "fixed/segment_tracing.h"
#include "fixed/triangle_graph.h"
#include "system/chains.h"
#include "system/disjoint_sets.h"
#include "system/three_floats.h"

namespace laplacian_lines {
namespace {

constexpr float kGoesOn = 0.5f;          // least cosine between two edges of a line
constexpr float kStraight = 0.9999985f;  // cosine of 0.1°: parts of an edge that was subdivided

/// Joins edges to lines, which end where other than two of them meet.
class CreaseTracer {
public:
    CreaseTracer(const ExtractorData& data, const std::vector<CreaseEdge>& edges, float least_angle,
                 TracedCreases& traced)
        : data_(data), traced_(traced) {
        traced.least_angle = least_angle;
        for (const CreaseEdge& edge : edges) {
            if (edge.shown_up_to < least_angle) continue;
            edges_.push_back(&edge);
            const std::uint32_t begin = crossing(edge, 0);
            graph_.segments.push_back({begin, crossing(edge, 1)});
            for (const std::uint32_t facet : edge.facets)
                if (facet != TriangleGraph::kNone) ++sides_of_facet_[facet];
        }
    }

    void run() {
        link_halves(graph_, memory_);
        memory_.visited.assign(edges_.size(), 0);
        for_each_chain(
            std::uint32_t(edges_.size()),
            [&](std::uint32_t half) { return memory_.linked_half[half]; },
            [&](std::uint32_t half) {
                if (!memory_.visited[half / 2]) trace(half);
            });
        join_nets();
    }

private:
    std::uint32_t crossing(const CreaseEdge& edge, int end) {
        const auto number = std::uint32_t(graph_.crossings.size());
        const auto [place, is_new] = crossing_of_vertex_.try_emplace(edge.vertices[end], number);
        if (is_new) {
            graph_.crossings.push_back({edge.positions[end], 0});
            nets_.add();
        }
        float& angle = graph_.crossings[place->second].gradient;
        angle = std::max(angle, edge.angle);
        return place->second;
    }

    void add_point(std::uint32_t number, const CreaseEdge* edge) {
        const Crossing& c = graph_.crossings[number];
        traced_.lines.points.push_back(
            {(data_.centre - data_.origin + data_.diagonal * c.position.cast<double>())
                 .cast<float>(),
             1, c.gradient, 1});
        traced_.edges.push_back(edge);
    }

    void trace(std::uint32_t start) {
        Polyline line;
        line.kind = LineKind::Crease;
        line.first = std::uint32_t(traced_.lines.points.size());
        TracedCreases::Net net;
        std::uint32_t last = start;
        Eigen::Vector3f first = Eigen::Vector3f::Zero(), direction = first;
        line.closed = follow_chain(
            start, [&](std::uint32_t half) { return memory_.linked_half[half]; },
            [&](std::uint32_t half) {
                memory_.visited[half / 2] = 1;
                const CreaseEdge& edge = *edges_[half / 2];
                add_point(crossing_at(graph_, half), &edge);
                line.length += edge.length();
                const Eigen::Vector3f next = direction_of(half);
                if (half == start)
                    first = next;
                else
                    net.faults += turns_sharply(direction, next);
                net.pieces += std::abs(dot(next, direction)) < kStraight;
                net.faults += count_facets(edge);
                direction = next;
                nets_.unite(crossing_at(graph_, half), crossing_at(graph_, half ^ 1));
                last = half ^ 1;
            });
        add_point(crossing_at(graph_, last), nullptr);
        line.count = std::uint32_t(traced_.lines.points.size()) - line.first;
        ends_.push_back({crossing_at(graph_, start), crossing_at(graph_, last)});
        traced_.lines.lines.push_back(line);
        net.length = line.length;
        net.faults += line.closed ? turns_sharply(direction, first) : loose_ends(ends_.back());
        traced_.nets.push_back(net);
    }

    Eigen::Vector3f direction_of(std::uint32_t half) const {
        const auto place = [&](std::uint32_t at) -> const Eigen::Vector3f& {
            return graph_.crossings[crossing_at(graph_, at)].position;
        };
        return unit(place(half ^ 1) - place(half));
    }

    /// Facets at an edge that have just one other side among the edges; each counts once.
    std::uint32_t count_facets(const CreaseEdge& edge) {
        std::uint32_t count = 0;
        for (const std::uint32_t facet : edge.facets) {
            if (facet == TriangleGraph::kNone) continue;
            std::uint32_t& sides = sides_of_facet_[facet];
            count += sides == 2;
            sides = 0;
        }
        return count;
    }

    static bool turns_sharply(const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
        return dot(from, to) < kGoesOn;
    }

    std::uint32_t loose_ends(const std::array<std::uint32_t, 2>& ends) const {
        return std::uint32_t(memory_.degree[ends[0]] == 1) + (memory_.degree[ends[1]] == 1);
    }

    /// Of lines alone, those of what is connected.
    void join_nets() {
        std::vector<TracedCreases::Net> joined(nets_.size());
        const auto net_of = [&](std::size_t i) -> TracedCreases::Net& {
            return joined[nets_.root(ends_[i][0])];
        };
        for (std::size_t i = 0; i < ends_.size(); ++i) {
            const TracedCreases::Net& own = traced_.nets[i];
            net_of(i).pieces += own.pieces;
            net_of(i).length += own.length;
            net_of(i).faults += own.faults;
        }
        for (std::size_t i = 0; i < ends_.size(); ++i)
            if (loose_ends(ends_[i]) == 0) traced_.nets[i] = net_of(i);
    }

    const ExtractorData& data_;
    TracedCreases& traced_;
    std::vector<const CreaseEdge*> edges_;  // by segment
    CrossingGraph graph_;
    TracingMemory memory_;
    std::unordered_map<std::uint32_t, std::uint32_t> crossing_of_vertex_, sides_of_facet_;
    std::vector<std::array<std::uint32_t, 2>> ends_;  // by line
    DisjointSets nets_;                               // of crossings
};

}  // namespace

TracedCreases trace_creases(const ExtractorData& data, const std::vector<CreaseEdge>& edges,
                            float least_angle) {
    TracedCreases traced;
    CreaseTracer(data, edges, least_angle, traced).run();
    return traced;
}

}  // namespace laplacian_lines
