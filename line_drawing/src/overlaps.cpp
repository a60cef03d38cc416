// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlaps.h"

#include <algorithm>
#include <cmath>

#include "refining.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double least_cosine = 0.94;  // of 20°
constexpr int overlap = 2;             // points of lines, which are at most a reach apart
constexpr double shortest_double = 4;  // reaches; where lines meet they are near for a while

double distanceTo(const Vector2d& begin, const Vector2d& end, const Vector2d& p) {
    const Vector2d way = end - begin;
    const double t = std::clamp(way.dot(p - begin) / way.squaredNorm(), 0., 1.);
    return (begin + t * way - p).norm();
}

double lengthOf(const DrawnLine& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
        length += (line.points[i].position - line.points[i - 1].position).norm();
    return length;
}

/// Sections are what a drawing with sections is about.
int rankOf(LineClass line_class) {
    return line_class == LineClass::Section ? -1 : int(line_class);
}

/// Cuts one line where it doubles others.
class LineCutter {
public:
    LineCutter(const DrawnLine& line, const DrawnLines& there, double reach)
        : line_(line), points_(refine(line.points, reach)), is_double_(points_.size()) {
        for (std::size_t i = 0; i < points_.size(); ++i)
            is_double_[i] = there.runsAlong(points_[i].position, wayAt(i));
        forgetShortRuns(reach);
        for (int i = 0; i < overlap; ++i)
            shortenRuns();
    }

    void appendRest(std::vector<DrawnLine>& rest) const {
        if (std::find(is_double_.begin(), is_double_.end(), true) == is_double_.end()) {
            rest.push_back(line_);
            return;
        }
        DrawnLine part{line_.line_class, false, {}};
        for (std::size_t i = 0; i <= points_.size(); ++i) {
            if (i < points_.size() && !is_double_[i]) {
                part.points.push_back(points_[i]);
            } else {
                if (part.points.size() > 1) rest.push_back(part);
                part.points.clear();
            }
        }
    }

private:
    Vector2d wayAt(std::size_t i) const {
        const std::size_t last = points_.size() - 1;
        return (points_[std::min(i + 1, last)].position - points_[i == 0 ? 0 : i - 1].position)
            .stableNormalized();
    }

    void forgetShortRuns(double reach) {
        for (std::size_t begin = 0; begin < points_.size();) {
            std::size_t end = begin;
            while (end < points_.size() && is_double_[end] == is_double_[begin])
                ++end;
            const double length = (points_[end - 1].position - points_[begin].position).norm();
            if (is_double_[begin] && length < shortest_double * reach)
                std::fill(is_double_.begin() + std::ptrdiff_t(begin),
                          is_double_.begin() + std::ptrdiff_t(end), false);
            begin = end;
        }
    }

    /// What is left ends beside the line that it doubled, so that there is no gap.
    void shortenRuns() {
        const std::vector<bool> before = is_double_;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const bool has_rest_beside =
                (i > 0 && !before[i - 1]) || (i + 1 < before.size() && !before[i + 1]);
            if (has_rest_beside) is_double_[i] = false;
        }
    }

    const DrawnLine& line_;
    const std::vector<DrawnPoint> points_;
    std::vector<bool> is_double_;
};

}  // namespace

DrawnLines::Cell DrawnLines::cellOf(double x, double y) const {
    const auto number = [&](double at) {
        return Cell(std::uint32_t(std::int64_t(std::floor(at / (2 * reach_)))));
    };
    return number(x) << 32 | number(y);
}

void DrawnLines::add(const std::vector<Vector2d>& line) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vector2d way = line[i] - line[i - 1];
        const double steps = std::ceil(way.norm() / reach_);
        for (double s = 0; s < steps; ++s) {  // pieces so short that each is in one square
            const Piece piece = {line[i - 1] + way * (s / steps),
                                 line[i - 1] + way * ((s + 1) / steps)};
            const Vector2d middle = (piece.begin + piece.end) / 2;
            pieces_[cellOf(middle.x(), middle.y())].push_back(piece);
        }
    }
}

bool DrawnLines::runsAlong(const Vector2d& point, const Vector2d& way) const {
    for (const double dx : {-2., 0., 2.})
        for (const double dy : {-2., 0., 2.}) {
            const auto found =
                pieces_.find(cellOf(point.x() + dx * reach_, point.y() + dy * reach_));
            if (found == pieces_.end()) continue;
            for (const Piece& piece : found->second) {
                const Vector2d along = (piece.end - piece.begin).normalized();
                if (std::abs(along.dot(way)) >= least_cosine &&
                    distanceTo(piece.begin, piece.end, point) < reach_)
                    return true;
            }
        }
    return false;
}

std::vector<DrawnLine> withoutDoubles(std::vector<DrawnLine> lines, double reach) {
    std::vector<std::pair<double, std::size_t>> order;  // -length, so that the longest come first
    for (std::size_t i = 0; i < lines.size(); ++i)
        order.emplace_back(-lengthOf(lines[i]), i);
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
        const int of_a = rankOf(lines[a.second].line_class),
                  of_b = rankOf(lines[b.second].line_class);
        return of_a != of_b ? of_a < of_b : a < b;
    });
    DrawnLines there(reach);
    std::vector<DrawnLine> rest;
    for (const auto& [length, i] : order) {
        std::size_t next = rest.size();
        if (lines[i].points.size() > 1) LineCutter(lines[i], there, reach).appendRest(rest);
        for (; next < rest.size(); ++next)
            there.add(positionsOf(rest[next]));
    }
    return rest;
}

}  // namespace line_drawing
