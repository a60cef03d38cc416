// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "system/disjoint_sets.h"
#include "visibility/picture.h"

namespace laplacian_lines {

/// Faces seen edge-on, within the eye's turn: whether one faces the eye is chance. One that faces
/// away has a contour before it. One that faces the eye and is tangent to its neighbours has none,
/// yet the surface drops there: its near edge is a contour as well.
class EdgeOnWalls {
public:
    explicit EdgeOnWalls(const Picture& picture);

    /// Whether an edge of two triangles that is not a fold is the near edge of such a face, without
    /// folds of the face beside it all along.
    bool drop_at(std::uint32_t edge) const;

private:
    bool is_wall(std::uint32_t triangle) const { return !is_wall_.empty() && is_wall_[triangle]; }
    std::uint32_t number_of(std::uint32_t wall) const;
    std::uint32_t face_of(std::uint32_t wall) const { return face_of_[number_of(wall)]; }
    void find_walls();
    std::vector<std::uint32_t> edges_of_walls() const;
    void join_faces(const std::vector<std::uint32_t>& edges);
    void note_folds(const std::vector<std::uint32_t>& edges);
    bool recedes(std::uint32_t edge, std::uint32_t triangle) const;
    bool cover(const std::vector<std::uint32_t>& edges, std::uint32_t other) const;

    const Picture& picture_;
    const SightMesh& mesh_;
    std::vector<std::uint8_t> is_wall_;   // by triangle; empty: none is
    std::vector<std::uint32_t> walls_;    // triangles, ascending
    std::vector<std::uint32_t> face_of_;  // by number of the wall
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> folds_;  // edges, by face
};

}  // namespace laplacian_lines
