// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <ostream>
#include <utility>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

/// Zero crossings and their chains written down plainly, without any filter.
namespace reference {

/// Finite corners that are not on one line.
bool has_area(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Triangle& t);

/// Values of ΔI = Δn·l and I = n·l, in double precision and in
/// the units of the mesh; only their signs and ratios matter. 0 at vertices that were left out.
struct Values {
    std::vector<double> laplacian, illumination;
};
Values evaluate(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Field& field,
                const laplacian_lines::View& view);

/// One piece of a zero line: the two edges (sorted vertex pairs) of a triangle that it joins.
struct Piece {
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::uint32_t triangle;
    std::array<Edge, 2> edges;
    std::array<Eigen::Vector3d, 2> ends;
};

/// Of all triangles with an area and corners of both signs; zero counts as positive.
std::vector<Piece> pieces(const laplacian_lines::TriangleMesh& mesh,
                          const std::vector<double>& values);

/// Pieces joined where exactly two of them meet.
struct Chain {
    std::size_t pieces = 0;
    bool closed = false;
    bool operator<(const Chain& o) const {
        return pieces != o.pieces ? pieces < o.pieces : closed < o.closed;
    }
    bool operator==(const Chain& o) const { return pieces == o.pieces && closed == o.closed; }
    friend std::ostream& operator<<(std::ostream& out, const Chain& c) {
        return out << c.pieces << (c.closed ? " closed" : " open");
    }
};
/// Sorted.
std::vector<Chain> chains(const std::vector<Piece>& pieces);
std::vector<Chain> chains(const laplacian_lines::LineSet& lines);

}  // namespace reference
