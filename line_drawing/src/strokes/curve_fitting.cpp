// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "strokes/refining.h"
#include "strokes/strokes.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;
using Cubic = std::array<Vector2d, 4>;

constexpr double kCosineOfCorner = 0.9063;  // 25°
constexpr double kCornerReach = 10;         // tolerances
constexpr int kMostImprovements = 4;
// In tolerances: Newton steps do not mend larger errors; curves flatter than the second are lines.
constexpr double kWorstMended = 4, kStraight = 0.05;
constexpr std::size_t kLongestRun = 256;  // points of a curve: bounds the work on a bad fit

Vector2d point_of(const Cubic& c, double t) {
    const double s = 1 - t;
    return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
}
Vector2d first_derivative(const Cubic& c, double t) {
    const double s = 1 - t;
    return 3 * (s * s * (c[1] - c[0]) + 2 * s * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
}
Vector2d second_derivative(const Cubic& c, double t) {
    return 6 * ((1 - t) * (c[2] - 2 * c[1] + c[0]) + t * (c[3] - 2 * c[2] + c[1]));
}

/// Fits curves to the points between two corners and appends them to a path.
/// P. Schneider, "An Algorithm for Automatically Fitting Digitized Curves", Graphics Gems, 1990.
class RunFitter {
public:
    RunFitter(const Points& points, double tolerance, Path& path)
        : points_(points),
          squared_tolerance_(tolerance * tolerance),
          reach_(kCornerReach * tolerance),
          path_(path) {}

    /// points[first..last], with unit tangents inwards at both ends.
    void fit(std::size_t first, std::size_t last, const Vector2d& begin, const Vector2d& end) {
        if (is_straight(first, last)) return path_.line_to(points_[last]);
        if (last - first > kLongestRun)
            return split(first, first + (last - first) / 2, last, begin, end);
        std::vector<double> parameters = {0};
        for (std::size_t i = first + 1; i <= last; ++i)
            parameters.push_back(parameters.back() + (points_[i] - points_[i - 1]).norm());
        const double length = parameters.back();
        for (double& t : parameters)
            t = length > 0 ? t / length : 0;
        std::size_t worst = first;
        for (int round = 0; round <= kMostImprovements; ++round) {
            const Cubic cubic = solve(first, parameters, length, begin, end);
            const double error = largest_error(cubic, first, parameters, worst);
            if (error <= squared_tolerance_) return path_.curve_to(cubic[1], cubic[2], cubic[3]);
            if (error > kWorstMended * kWorstMended * squared_tolerance_) break;
            improve(cubic, first, parameters);
        }
        split(first, std::clamp(worst, first + 1, last - 1), last, begin, end);
    }

    /// Inwards from an end of a run.
    Vector2d tangent_from(std::size_t end, std::size_t other) const {
        const std::ptrdiff_t step = other > end ? 1 : -1;
        std::size_t i = end;
        do
            i = std::size_t(std::ptrdiff_t(i) + step);
        while (i != other && (points_[i] - points_[end]).norm() < reach_ / 2);
        return (points_[i] - points_[end]).stableNormalized();
    }

private:
    bool is_straight(std::size_t first, std::size_t last) const {
        const Vector2d whole = points_[last] - points_[first], way = whole.stableNormalized();
        if (way.isZero()) return false;
        for (std::size_t i = first + 1; i < last; ++i) {
            const Vector2d off = points_[i] - points_[first];
            const double along = way.dot(off), across = way.x() * off.y() - way.y() * off.x();
            const double beyond = std::max({-along, along - whole.norm(), std::abs(across)});
            if (beyond * beyond > kStraight * kStraight * squared_tolerance_) return false;
        }
        return true;
    }

    void split(std::size_t first, std::size_t middle, std::size_t last, const Vector2d& begin,
               const Vector2d& end) {
        const Vector2d before = tangent_from(middle, first),
                       both = before - tangent_from(middle, last),
                       tangent = both.squaredNorm() > 1e-6 ? both.normalized() : before;
        fit(first, middle, begin, tangent);
        fit(middle, last, -tangent, end);
    }

    /// Least squares for the lengths of both tangents.
    Cubic solve(std::size_t first, const std::vector<double>& parameters, double length,
                const Vector2d& begin, const Vector2d& end) const {
        const Vector2d& p0 = points_[first];
        const Vector2d& p3 = points_[first + parameters.size() - 1];
        double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0;
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const double t = parameters[i], s = 1 - t;
            const double b1 = 3 * s * s * t, b2 = 3 * s * t * t;
            const Vector2d a0 = b1 * begin, a1 = b2 * end;
            const Vector2d rest =
                points_[first + i] - (s * s * s + b1) * p0 - (t * t * t + b2) * p3;
            c00 += a0.dot(a0);
            c01 += a0.dot(a1);
            c11 += a1.dot(a1);
            x0 += a0.dot(rest);
            x1 += a1.dot(rest);
        }
        const double determinant = c00 * c11 - c01 * c01;
        const double chord = (p3 - p0).norm(), least = 1e-6 * chord;
        double length0 = 0, length1 = 0;
        if (std::abs(determinant) > 1e-12 * c00 * c11) {
            length0 = (x0 * c11 - x1 * c01) / determinant;
            length1 = (c00 * x1 - c01 * x0) / determinant;
        }
        // Both forwards, and together no longer than the line: longer handles let the curve leap
        // between the points.
        if (!(length0 > least) || !(length1 > least) || length0 + length1 > length)
            length0 = length1 = chord / 3;
        return {p0, p0 + length0 * begin, p3 + length1 * end, p3};
    }

    /// Squared.
    double largest_error(const Cubic& cubic, std::size_t first,
                         const std::vector<double>& parameters, std::size_t& worst) const {
        double largest = 0;
        for (std::size_t i = 1; i + 1 < parameters.size(); ++i) {
            const double error =
                (point_of(cubic, parameters[i]) - points_[first + i]).squaredNorm();
            if (!(error > largest)) continue;
            largest = error;
            worst = first + i;
        }
        return largest;
    }

    /// A Newton step for each point's nearest place on the curve.
    void improve(const Cubic& cubic, std::size_t first, std::vector<double>& parameters) const {
        for (std::size_t i = 1; i + 1 < parameters.size(); ++i) {
            const Vector2d off = point_of(cubic, parameters[i]) - points_[first + i];
            const Vector2d d1 = first_derivative(cubic, parameters[i]);
            const double slope =
                d1.squaredNorm() + off.dot(second_derivative(cubic, parameters[i]));
            if (slope > 0) parameters[i] = std::clamp(parameters[i] - off.dot(d1) / slope, 0., 1.);
        }
    }

    const Points& points_;
    const double squared_tolerance_, reach_;
    Path& path_;
};

/// Unit, from points[i] to the next point at a distance of at least `reach`, or to the end of the
/// line; around closed lines. Zero if that point is nearer than half of `reach`.
Vector2d direction_to(const Points& points, bool closed, std::size_t i, int step, double reach) {
    const auto n = std::ptrdiff_t(points.size()) - 1;  // closed lines repeat their first point
    std::ptrdiff_t at = std::ptrdiff_t(i);
    for (std::ptrdiff_t steps = 0; steps < n; ++steps) {
        if (!closed && (at + step < 0 || at + step > n)) break;
        at = closed ? (at + step + n) % n : at + step;
        if ((points[std::size_t(at)] - points[i]).norm() >= reach) break;
    }
    const Vector2d way = points[std::size_t(at)] - points[i];
    return way.norm() >= reach / 2 ? Vector2d(way.normalized()) : Vector2d(0, 0);
}

/// Where `points` turn by more than 25° within `reach`, without the ends of open lines.
std::vector<std::size_t> find_corners(const Points& points, bool closed, double reach) {
    const std::size_t n = points.size();
    std::vector<double> turns(n, 1);  // cosines
    const std::size_t end = closed ? n - 1 : n;
    for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < end; ++i) {
        const Vector2d back = direction_to(points, closed, i, -1, reach);
        const Vector2d on = direction_to(points, closed, i, 1, reach);
        if (!back.isZero() && !on.isZero()) turns[i] = -back.dot(on);
    }
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < end; ++i) {
        if (!(turns[i] < kCosineOfCorner)) continue;
        // The sharpest of those that see the same turn.
        if (!corners.empty() && (points[corners.back()] - points[i]).norm() < reach) {
            if (turns[i] < turns[corners.back()]) corners.back() = i;
        } else {
            corners.push_back(i);
        }
    }
    if (closed && corners.size() > 1 &&  // likewise around the beginning
        (points[corners.front()] - points[corners.back()]).norm() < reach) {
        if (turns[corners.back()] < turns[corners.front()])
            corners.erase(corners.begin());
        else
            corners.pop_back();
    }
    return corners;
}

}  // namespace

void fit_curve(const Points& given, bool closed, double tolerance, Path& path) {
    // So that curves near the points are near the line between them, too.
    Points points = refine(given, kCornerReach * tolerance);
    if (points.size() < 2) return;
    closed = closed && points.size() > 3 && points.front() == points.back();
    std::vector<std::size_t> corners = find_corners(points, closed, kCornerReach * tolerance);
    if (closed && !corners.empty() && corners[0] != 0) {  // to begin with a corner
        const std::size_t shift = corners[0];
        begin_at(shift, points);
        for (std::size_t& corner : corners)
            corner -= shift;
    }
    const bool is_smooth_loop = closed && corners.empty();
    if (corners.empty() || corners.front() != 0) corners.insert(corners.begin(), 0);
    if (corners.back() != points.size() - 1) corners.push_back(points.size() - 1);
    path.move_to(points[0]);
    RunFitter fitter(points, tolerance, path);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        Vector2d begin = fitter.tangent_from(corners[i], corners[i + 1]);
        Vector2d end = fitter.tangent_from(corners[i + 1], corners[i]);
        if (is_smooth_loop) {
            begin = (begin - end).stableNormalized();
            end = -begin;
        }
        fitter.fit(corners[i], corners[i + 1], begin, end);
    }
    if (closed) path.close();
}

}  // namespace line_drawing
