// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace test_meshes {

/// A short piece of an edge of a form, sharp or rounded. Pieces are in no order.
struct ArrisPiece {
    Eigen::Vector3d a, b;    ///< its ends, on the rounded surface
    double angle = 0;        ///< between the normals on both sides, degrees
    Eigen::Vector3d normal;  ///< unit, in the middle between those
    bool convex = true;

    double length() const { return (b - a).norm(); }
    Eigen::Vector3d middle() const { return (a + b) / 2; }
};

inline double total_length(const std::vector<ArrisPiece>& pieces) {
    double sum = 0;
    for (const ArrisPiece& piece : pieces)
        sum += piece.length();
    return sum;
}

}  // namespace test_meshes
