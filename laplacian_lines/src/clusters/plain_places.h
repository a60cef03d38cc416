// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/prepared_mesh.h"

namespace laplacian_lines {

/// How the triangles around a vertex lie to the first one of them in the mesh.
enum class Around : std::uint8_t {
    Flat,   ///< all within 0.1°
    Round,  ///< between the two
    Sharp,  ///< one at 40° or more
};

/// Where the surface has no form of its own that a Laplacian line could tell of, so that what is
/// found there comes from beyond an edge, over which the kernel reaches.
class PlainPlaces {
public:
    /// Keeps a reference to the mesh. The number of threads does not matter.
    explicit PlainPlaces(const PreparedMesh& mesh);

    Around around(std::uint32_t vertex) const { return around_[vertex]; }

    /// Whether a triangle is flat to its whole ring, or so long, in D, that flat and sharp corners
    /// are all there is of the form. Nowhere on a mesh without a sharp corner.
    bool contain(std::uint32_t triangle) const;

private:
    const PreparedMesh& mesh_;
    std::vector<Around> around_;  // by vertex
    bool has_edges_;
};

}  // namespace laplacian_lines
