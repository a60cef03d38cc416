// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "fixed/crease_criteria.h"
#include "system/three_floats.h"

namespace laplacian_lines {

/// Numbers of triangles, a few.
class TriangleSet {
public:
    explicit TriangleSet(std::size_t most) {
        std::size_t size = 4;
        while (size < 2 * most)
            size *= 2;
        slots_.assign(size, TriangleGraph::kNone);
    }
    bool contains(std::uint32_t triangle) const { return slots_[slot_of(triangle)] == triangle; }
    void add(std::uint32_t triangle) { slots_[slot_of(triangle)] = triangle; }

private:
    /// Where it is, or could be.
    std::size_t slot_of(std::uint32_t triangle) const {
        std::size_t slot = triangle * 0x9e3779b1u & (slots_.size() - 1);
        while (slots_[slot] != TriangleGraph::kNone && slots_[slot] != triangle)
            slot = (slot + 1) & (slots_.size() - 1);
        return slot;
    }

    std::vector<std::uint32_t> slots_;
};

/// The surface on one side of a bent edge: triangles from the one at the edge on, in rings.
class EdgeSide {
public:
    static constexpr std::size_t kMostTriangles = 24;  // as they were measured

    /// The edge's own triangle's side, or the one beyond. Signs turn normals to agree with that of
    /// the edge's own triangle.
    EdgeSide(const TriangleGraph& graph, const BentEdge& edge, bool beyond) : graph_(graph) {
        const TriangleGraph::Node& own = graph.triangles[edge.triangle];
        const std::uint32_t other = own.neighbours[edge.side];
        const float sign = own.sign_across(edge.side);
        start_ = beyond ? other : edge.triangle;
        opposite_ = beyond ? edge.triangle : other;
        sign_ = beyond ? sign : 1;
        const Eigen::Vector3f a = graph.position(edge.triangle, edge.side);
        const Eigen::Vector3f b = graph.position(edge.triangle, (edge.side + 1) % 3);
        middle_ = (a + b) / 2;
        along_ = b - a;
        length_ = length_of(along_);
        if (length_ > 0) along_ /= length_;
        const Eigen::Vector3f inwards = own.normal.cross(along_);
        const Eigen::Vector3f outwards = sign * graph.triangles[other].normal.cross(-along_);
        away_ = beyond ? outwards - inwards : inwards - outwards;
    }

    float length() const { return length_; }                     ///< of the edge
    const Eigen::Vector3f& middle() const { return middle_; }    ///< of the edge
    const Eigen::Vector3f& direction() const { return along_; }  ///< of the edge, unit
    /// Height of the triangle at the edge.
    float height() const { return length_ > 0 ? 2 * graph_.triangles[start_].area / length_ : 0; }
    /// Whether side k of a triangle is the edge itself.
    bool is_edge(std::uint32_t triangle, unsigned k) const {
        return triangle == start_ && graph_.triangles[triangle].neighbours[k] == opposite_;
    }

    /// Whether a place is on this side of the plane that halves the angle at the edge, and within
    /// these distances of the edge.
    bool is_near(const Eigen::Vector3f& p, float across, float along) const {
        const Eigen::Vector3f offset = p - middle_;
        const float farthest = across + along + length_ / 2;
        return dot(offset, away_) > 0 && std::abs(dot(offset, along_)) <= length_ / 2 + along &&
               squared_length_of(offset) <= farthest * farthest;
    }

    /// Calls visit(triangle, sign) for triangles as far as one leads to the next with
    /// passes(triangle, side) into those for which holds(triangle), and while `visit` is true.
    /// Returns whether it always was.
    template <class Passes, class Holds, class Visit>
    bool visit(const Passes& passes, const Holds& holds, const Visit& visit) const {
        const std::size_t most = kMostTriangles * graph_.subdivision;
        std::vector<std::uint32_t> visited = {start_};
        std::vector<float> signs = {sign_};
        TriangleSet known(most);
        known.add(start_);
        for (std::size_t i = 0; i < visited.size(); ++i) {
            if (!visit(visited[i], signs[i])) return false;
            const TriangleGraph::Node& node = graph_.triangles[visited[i]];
            for (unsigned k = 0; k < 3 && visited.size() < most; ++k) {
                const std::uint32_t next = node.neighbours[k];
                if (next == TriangleGraph::kNone || next == opposite_ || !holds(next) ||
                    known.contains(next) || !passes(visited[i], k))
                    continue;
                signs.push_back(signs[i] * node.sign_across(k));
                visited.push_back(next);
                known.add(next);
            }
        }
        return true;
    }

private:
    const TriangleGraph& graph_;
    std::uint32_t start_, opposite_;
    float sign_, length_;
    Eigen::Vector3f middle_, along_, away_;
};

}  // namespace laplacian_lines
