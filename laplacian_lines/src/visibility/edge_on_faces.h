// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "visibility/picture.h"

namespace laplacian_lines {

/// Flat faces seen edge-on, within twice the angle by which the eye is turned: whether one faces
/// the eye is chance. If it faces away, it has a contour in front. If it and its neighbours face
/// the eye, it has none; its near edge is then made a contour, for the depth jumps there.
class EdgeOnFaces {
public:
    /// The picture outlives the object.
    explicit EdgeOnFaces(const Picture& picture);

    /// Whether an edge that is no contour is to be made one: of two triangles, it is the near edge
    /// of such a face and not covered by the face's contours.
    bool needs_contour(std::uint32_t edge) const;

private:
    using Edges = std::vector<std::uint32_t>;

    void find_triangles();
    Edges edges_of_triangles() const;
    void join_triangles(const Edges& edges);
    void note_contours(const Edges& edges);
    bool is_edge_on(std::uint32_t triangle) const;
    std::uint32_t number_of(std::uint32_t triangle) const;
    std::uint32_t face_of(std::uint32_t triangle) const;
    bool recedes(std::uint32_t edge, std::uint32_t triangle) const;
    bool cover(const Edges& edges, std::uint32_t other) const;

    const Picture& picture_;
    const VisibilityMesh& mesh_;
    std::vector<std::uint8_t> is_edge_on_;               // by triangle; empty: none is
    std::vector<std::uint32_t> triangles_;               // those edge-on, ascending
    std::vector<std::uint32_t> face_of_;                 // by index in triangles_
    std::unordered_map<std::uint32_t, Edges> contours_;  // by face
};

}  // namespace laplacian_lines
