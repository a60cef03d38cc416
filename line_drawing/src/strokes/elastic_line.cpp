// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/line_easing.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace line_drawing {
namespace {

constexpr int rounds = 60;
/// For being off a point's place: the first rounds take out waves of some twenty points.
constexpr double penalty = 0.01, penalty_of_fixed = 100;

using Matrix = Eigen::SparseMatrix<double>;

/// Second differences.
Matrix bends(Eigen::Index n, bool closed) {
    std::vector<Eigen::Triplet<double>> entries;
    const Eigen::Index first = closed ? 0 : 1, end = closed ? n : n - 1;
    for (Eigen::Index i = first; i < end; ++i) {
        entries.emplace_back(i, (i + n - 1) % n, 1);
        entries.emplace_back(i, i, -2);
        entries.emplace_back(i, (i + 1) % n, 1);
    }
    Matrix result(n, n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

void pullInto(const EvenPoints& middles, const std::vector<double>& reach, EvenPoints& points) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::RowVector2d off = points.row(i) - middles.row(i);
        const double distance = off.norm(), most = reach[std::size_t(i)];
        if (distance > most) points.row(i) = middles.row(i) + most / distance * off;
    }
}

}  // namespace

EvenPoints bendLeast(const EvenPoints& points, const std::vector<double>& reach, bool closed) {
    const Eigen::Index n = points.rows();
    if (n < 3) return points;
    const Matrix second = bends(n, closed);
    Eigen::VectorXd penalties(n);
    for (Eigen::Index i = 0; i < n; ++i)
        penalties[i] = reach[std::size_t(i)] > 0 ? penalty : penalty_of_fixed;
    Matrix system = second.transpose() * second;
    system += Matrix(penalties.asDiagonal());
    const Eigen::SimplicialLDLT<Matrix> solver(system);
    EvenPoints inside = points, smooth = points, scaled_dual = EvenPoints::Zero(n, 2);
    for (int round = 0; round < rounds; ++round) {
        smooth = solver.solve(penalties.asDiagonal() * (inside - scaled_dual));
        inside = smooth + scaled_dual;
        pullInto(points, reach, inside);
        scaled_dual += smooth - inside;
    }
    pullInto(points, reach, smooth);
    return smooth;
}

}  // namespace line_drawing
