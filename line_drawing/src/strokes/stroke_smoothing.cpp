// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "laplacian_lines/threads.h"
#include "strokes/refining.h"
#include "strokes/strokes.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double kStepShare = 1.5;  // of the reach, between the places that are moved
constexpr int kRounds = 60;         // of bend_least()
// Its weights ρ of a point's squared distance from its place within reach: a round takes out waves
// shorter than 2π/ρ^¼ points, here twenty.
constexpr double kPenalty = 0.01, kPenaltyOfFixed = 100;

using EvenPoints = Eigen::Matrix<double, Eigen::Dynamic, 2>;
using Matrix = Eigen::SparseMatrix<double>;

/// The second differences of n points; zero at the ends of an open line.
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

/// Moves points that are farther than `reach` from `middles` back to that distance.
void pull_into(const EvenPoints& middles, const std::vector<double>& reach, EvenPoints& points) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::RowVector2d off = points.row(i) - middles.row(i);
        const double distance = off.norm(), most = reach[std::size_t(i)];
        if (distance > most) points.row(i) = middles.row(i) + most / distance * off;
    }
}

/// Moves points so that the line bends least, Σ |x[i-1] - 2 x[i] + x[i+1]|², each within its
/// `reach`: an elastic line in a tube, without corners where it touches. A closed line does not
/// repeat its first point. By the alternating direction method of multipliers: Boyd et al.,
/// "Distributed Optimization and Statistical Learning via the Alternating Direction Method of
/// Multipliers" (2011), section 5.2.
EvenPoints bend_least(const EvenPoints& points, const std::vector<double>& reach, bool closed) {
    const Eigen::Index n = points.rows();
    if (n < 3) return points;
    const Matrix second = bends(n, closed);
    Eigen::VectorXd penalties(n);
    for (Eigen::Index i = 0; i < n; ++i)
        penalties[i] = reach[std::size_t(i)] > 0 ? kPenalty : kPenaltyOfFixed;
    Matrix system = second.transpose() * second;
    system += Matrix(penalties.asDiagonal());
    const Eigen::SimplicialLDLT<Matrix> solver(system);
    EvenPoints inside = points, smooth = points, scaled_dual = EvenPoints::Zero(n, 2);
    for (int round = 0; round < kRounds; ++round) {
        smooth = solver.solve(penalties.asDiagonal() * (inside - scaled_dual));
        inside = smooth + scaled_dual;
        pull_into(points, reach, inside);
        scaled_dual += smooth - inside;
    }
    pull_into(points, reach, smooth);
    return smooth;
}

/// A run of a line, resampled at equal distances.
class EvenLine {
public:
    EvenLine(const std::vector<DrawnPoint>& points, double step) : points_(points) {
        for (std::size_t i = 0; i < points.size(); ++i)
            along_.push_back(i == 0 ? 0 : along_.back() + length_of(points, i - 1, i + 1));
        steps_ = std::size_t(std::ceil(along_.back() / step));
    }

    bool is_long() const { return steps_ >= 2; }

    /// Pieces between two exact points stay, and the ends of an open line.
    void smooth(double reach, bool closed) {
        const std::size_t count = closed ? steps_ : steps_ + 1;
        EvenPoints places(Eigen::Index(count), 2);
        std::vector<double> reaches(count, reach);
        for (std::size_t i = 0; i < count; ++i) {
            even_.push_back(point_at(double(i) / double(steps_) * along_.back()));
            places.row(Eigen::Index(i)) = even_[i].position.transpose();
            if (even_[i].stays()) reaches[i] = 0;
        }
        if (!closed) reaches.front() = reaches.back() = 0;
        places = bend_least(places, reaches, closed);
        for (std::size_t i = 0; i < count; ++i)
            even_[i].position = places.row(Eigen::Index(i)).transpose();
        if (closed) even_.push_back(even_.front());
        even_.front().node = points_.front().node;
        even_.back().node = points_.back().node;
    }

    const std::vector<DrawnPoint>& result() const { return even_; }

    /// Where a point of the line is now.
    Vector2d place_of(std::size_t point) const {
        const double at = along_[point] / along_.back() * double(steps_);
        const std::size_t i = std::min(std::size_t(at), steps_ - 1);
        return between(even_[i].position, even_[i + 1].position, at - double(i));
    }

private:
    DrawnPoint point_at(double length) const {
        const auto after = std::lower_bound(along_.begin(), along_.end(), length);
        const std::size_t i = std::min(std::size_t(after - along_.begin()), along_.size() - 1);
        if (i == 0) return points_[0];
        const double t = (length - along_[i - 1]) / (along_[i] - along_[i - 1]);
        return between(points_[i - 1], points_[i], t);
    }

    const std::vector<DrawnPoint>& points_;
    std::vector<double> along_;  // of the points
    std::size_t steps_ = 0;
    std::vector<DrawnPoint> even_;
};

class ContourSmoother {
public:
    explicit ContourSmoother(double reach) : reach_(reach) {}

    /// Smooths the lines of a class.
    void smooth(LineClass line_class, std::vector<DrawnLine>& lines) {
        std::vector<Moved> moved(lines.size());
        laplacian_lines::in_parallel(lines.size(), [&](std::size_t i) {
            if (lines[i].line_class == line_class && lines[i].points.size() > 2)
                smooth(lines[i], moved[i]);
        });
        for (const Moved& of_line : moved)
            for (const auto& [node, place] : of_line)
                moved_.try_emplace(node, place);
    }

    /// Moves ends with the lines that they meet.
    void follow(DrawnLine& line) const {
        if (line.closed) return;
        for (DrawnPoint* end : {&line.points.front(), &line.points.back()}) {
            const auto moved = moved_.find(end->node);
            if (moved != moved_.end()) end->position = moved->second;
        }
    }

private:
    using Moved = std::vector<std::pair<std::uint32_t, Vector2d>>;  // nodes, and where they are now

    void smooth(DrawnLine& line, Moved& moved) const {
        const std::vector<DrawnPoint>& points = line.points;
        if (line.closed && !begin_at_exact(line)) {
            line.points = smoothed_stretch(points, true, moved);
            return;
        }
        std::vector<DrawnPoint> smoothed;
        const auto last = points.end() - 1;
        for (auto begin = points.begin(), end = begin; begin != last; begin = end) {
            end = std::find_if(begin + 1, last, is_exact);
            const auto part = smoothed_stretch({begin, end + 1}, false, moved);
            smoothed.insert(smoothed.end(), part.begin() + (smoothed.empty() ? 0 : 1), part.end());
        }
        line.points = std::move(smoothed);
    }

    static bool is_exact(const DrawnPoint& point) { return point.is_exact; }

    /// Rotates a closed line to begin at an exact point; false if it has none.
    static bool begin_at_exact(DrawnLine& line) {
        std::vector<DrawnPoint>& points = line.points;
        const auto first = std::find_if(points.begin(), points.end() - 1, is_exact);
        if (first == points.end() - 1) return false;
        begin_at(std::size_t(first - points.begin()), points);
        return true;
    }

    std::vector<DrawnPoint> smoothed_stretch(const std::vector<DrawnPoint>& points, bool closed,
                                             Moved& moved) const {
        if (points.size() < 3) return points;
        EvenLine even(points, kStepShare * reach_);
        if (!even.is_long()) return points;
        even.smooth(reach_, closed);
        for (std::size_t i = closed ? 0 : 1; i + 1 < points.size(); ++i)
            if (points[i].node != laplacian_lines::kNoNode)
                moved.emplace_back(points[i].node, even.place_of(i));
        return even.result();
    }

    const double reach_;
    std::unordered_map<std::uint32_t, Vector2d> moved_;  // nodes
};

}  // namespace

void smooth_contours(std::vector<DrawnLine>& lines, double reach) {
    ContourSmoother smoother(reach);
    for (const LineClass c : {LineClass::Outline, LineClass::Contour}) {
        smoother.smooth(c, lines);
        for (DrawnLine& line : lines)
            smoother.follow(line);
    }
    for (DrawnLine& line : lines)
        if (line.line_class == LineClass::Outline || line.line_class == LineClass::Contour)
            for (DrawnPoint& point : line.points)
                point.is_smoothed = true;
}

void smooth_inner_lines(std::vector<DrawnLine>& lines, double reach) {
    laplacian_lines::in_parallel(lines.size(), [&](std::size_t i) {
        DrawnLine& line = lines[i];
        if (is_fixed(line) || line.points.size() < 3) return;
        EvenLine even(line.points, kStepShare * reach);
        if (!even.is_long()) return;
        even.smooth(reach, line.closed);
        line.points = even.result();
    });
}

}  // namespace line_drawing
