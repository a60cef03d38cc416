// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlaps.h"

#include <algorithm>
#include <cmath>

#include "refining.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double least_cosine = 0.94;  // of 20°
constexpr double shortest_double = 4;  // reaches; where lines meet they are near for a while
constexpr double same_share = 0.1;     // of the reach: so near, a line adds nothing however short
constexpr double step_share = 0.25;    // of the reach: between the places of a line looked at
constexpr int overlap = 5;             // of these places, a little more than a reach
constexpr double reversal = -0.5;      // cosine of a turn by 120°
// Of the length of a line of at most two shortest doubles: the share beside others from which it
// adds nothing.
constexpr double most_beside = 0.8;
constexpr double beside_reach = 1.4;  // reaches: nearer ones have no white between them
constexpr double end_share = 0.5;     // of a piece of a line: beyond its end is not beside it

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

/// Takes the jogs out of a line, where it runs back along itself and then on: on paper they would
/// be knots of its stroke.
class JogRemoval {
public:
    JogRemoval(const DrawnLine& line, double reach)
        : line_(line), points_(refine(line.points, step_share * reach)), reach_(reach) {}

    DrawnLine result() const {
        DrawnLine straight{line_.line_class, line_.closed, {}};
        for (std::size_t i = 0; i < points_.size(); i = nextAfter(i))
            straight.points.push_back(points_[i]);
        return straight.points.size() == points_.size() ? line_ : straight;
    }

private:
    const Vector2d& at(std::size_t i) const { return points_[i].position; }

    /// The direction in which the line runs for a short way before a point, or after it.
    Vector2d way(std::size_t i, bool after) const {
        std::size_t k = i;
        const std::size_t end = after ? points_.size() - 1 : 0;
        while (k != end && (at(k) - at(i)).norm() < step_share * reach_)
            after ? ++k : --k;
        return ((after ? 1 : -1) * (at(k) - at(i))).stableNormalized();
    }

    /// The point with which the line goes on, past the jog that begins here, if one does.
    std::size_t nextAfter(std::size_t i) const {
        if (i == 0 || i + 1 == points_.size()) return i + 1;
        const Vector2d before = way(i, false);
        if ((at(i + 1) - at(i)).normalized().dot(before) > reversal) return i + 1;
        double length = 0;
        for (std::size_t k = i + 1; k + 1 < points_.size(); ++k) {
            length += (at(k) - at(k - 1)).norm();
            const Vector2d aside = at(k) - at(i);
            if (length > shortest_double * reach_) break;
            if (aside.norm() < reach_ && aside.dot(before) > 0 && way(k, true).dot(before) > 0)
                return k;
        }
        return i + 1;
    }

    const DrawnLine& line_;
    const std::vector<DrawnPoint> points_;
    const double reach_;
};

/// Cuts one line where it doubles others.
class LineCutter {
public:
    LineCutter(const DrawnLine& line, const DrawnLines& there, double reach)
        : line_(line),
          points_(refine(line.points, step_share * reach)),
          is_double_(points_.size()) {
        std::vector<bool> is_same(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const double distance = there.distanceAlong(points_[i].position, wayAt(i));
            is_double_[i] = distance < reach;
            is_same[i] = distance < same_share * reach;
        }
        forgetShortRuns(is_double_, shortest_double * reach);
        forgetShortRuns(is_same, step_share * reach / 2);
        for (int i = 0; i < overlap; ++i)
            shortenRuns();
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (is_same[i]) is_double_[i] = true;
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

    void forgetShortRuns(std::vector<bool>& is_in, double shortest) const {
        for (std::size_t begin = 0; begin < is_in.size();) {
            std::size_t end = begin;
            while (end < is_in.size() && is_in[end] == is_in[begin])
                ++end;
            const double length = (points_[end - 1].position - points_[begin].position).norm();
            if (is_in[begin] && length < shortest)
                std::fill(is_in.begin() + std::ptrdiff_t(begin),
                          is_in.begin() + std::ptrdiff_t(end), false);
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

template <class Visit>
void DrawnLines::forEachPieceNear(const Vector2d& point, Visit visit) const {
    for (const double dx : {-2., 0., 2.})
        for (const double dy : {-2., 0., 2.}) {
            const auto found =
                pieces_.find(cellOf(point.x() + dx * reach_, point.y() + dy * reach_));
            if (found == pieces_.end()) continue;
            for (const Piece& piece : found->second)
                visit(piece);
        }
}

double DrawnLines::distanceAlong(const Vector2d& point, const Vector2d& way) const {
    double least = reach_;
    forEachPieceNear(point, [&](const Piece& piece) {
        const Vector2d along = (piece.end - piece.begin).normalized();
        if (std::abs(along.dot(way)) >= least_cosine)
            least = std::min(least, distanceTo(piece.begin, piece.end, point));
    });
    return least;
}

bool DrawnLines::isBeside(const Vector2d& point, double within) const {
    bool is_beside = false;
    forEachPieceNear(point, [&](const Piece& piece) {
        const Vector2d way = piece.end - piece.begin;
        const double t = way.dot(point - piece.begin) / way.squaredNorm();
        const bool is_past = t < -end_share || t > 1 + end_share;
        is_beside |= !is_past && distanceTo(piece.begin, piece.end, point) < within;
    });
    return is_beside;
}

bool DrawnLines::addsNothing(const DrawnLine& line) const {
    if (lengthOf(line) > 2 * shortest_double * reach_) return false;
    for (const DrawnPoint& end : {line.points.front(), line.points.back()})
        if (!isBeside(end.position, reach_)) return false;  // another line may end there
    const std::vector<DrawnPoint> points = refine(line.points, step_share * reach_);
    const auto beside = std::count_if(points.begin(), points.end(), [&](const DrawnPoint& point) {
        return isBeside(point.position, beside_reach * reach_);
    });
    return double(beside) >= most_beside * double(points.size());
}

std::vector<DrawnLine> withoutDoubles(std::vector<DrawnLine> lines, double reach) {
    for (DrawnLine& line : lines)
        if (line.points.size() > 2) line = JogRemoval(line, reach).result();
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
        rest.erase(std::remove_if(rest.begin() + std::ptrdiff_t(next), rest.end(),
                                  [&](const DrawnLine& part) { return there.addsNothing(part); }),
                   rest.end());
        for (; next < rest.size(); ++next)
            there.add(positionsOf(rest[next]));
    }
    return rest;
}

}  // namespace line_drawing
