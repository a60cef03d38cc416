// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

#include <algorithm>
#include <numeric>

#include "strokes/drawn_lines.h"
#include "strokes/refining.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

constexpr double kShortestDouble = 4;  // reaches; where lines meet they are near for a while
constexpr double kStepShare = 0.25;    // of the reach: between the places of a line looked at
constexpr double kClosedGap = 1.5;  // reaches, .6 of an outline's pen: round ends hide most of it
constexpr int kOverlap = 5;         // places looked at, a little more than a reach
// Short lines, of up to two shortest doubles, with this share beside others add nothing.
constexpr double kMostBeside = 0.8;

/// Sections first: drawings with sections are about them.
int rank_of(LineClass line_class) {
    return line_class == LineClass::Section ? -1 : int(line_class);
}

/// Removes jogs, where a line doubles back and then continues: they would be knots in its stroke.
class JogRemoval {
public:
    JogRemoval(const DrawnLine& line, double reach)
        : line_(line), points_(refine(line.points, kStepShare * reach)), reach_(reach) {}

    DrawnLine result() const {
        DrawnLine straight = with_points(line_, {}, line_.closed);
        for (std::size_t i = 0; i < points_.size(); i = next_after(i))
            straight.points.push_back(points_[i]);
        return straight.points.size() == points_.size() ? line_ : straight;
    }

private:
    const Vector2d& at(std::size_t i) const { return points_[i].position; }

    /// Direction of the line just before or after a point.
    Vector2d way(std::size_t i, bool after) const {
        std::size_t k = i;
        const std::size_t end = after ? points_.size() - 1 : 0;
        while (k != end && (at(k) - at(i)).norm() < kStepShare * reach_)
            after ? ++k : --k;
        return ((after ? 1 : -1) * (at(k) - at(i))).stableNormalized();
    }

    /// The point after the jog that begins here, if one does.
    std::size_t next_after(std::size_t i) const {
        if (i == 0 || i + 1 == points_.size()) return i + 1;
        const Vector2d before = way(i, false);
        if ((at(i + 1) - at(i)).normalized().dot(before) > kReversal) return i + 1;
        double length = 0;
        for (std::size_t k = i + 1; k + 1 < points_.size(); ++k) {
            length += (at(k) - at(k - 1)).norm();
            const Vector2d aside = at(k) - at(i);
            if (length > kShortestDouble * reach_) break;
            if (aside.norm() < reach_ && aside.dot(before) > 0 && way(k, true).dot(before) > 0)
                return k;
        }
        return i + 1;
    }

    const DrawnLine& line_;
    const std::vector<DrawnPoint> points_;
    const double reach_;
};

/// Cuts out the parts of a line that double others.
class LineCutter {
public:
    LineCutter(const DrawnLine& line, const DrawnLines& there, double reach)
        : line_(line),
          points_(refine(line.points, kStepShare * reach)),
          is_double_(points_.size()) {
        std::vector<bool> is_same(points_.size()), is_beside(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) {
            is_double_[i] = there.run_along(points_[i].position, way_at(i), reach);
            is_beside[i] = is_double_[i] && there.run_along(points_[i].position, way_at(i), reach,
                                                            kSameReach * reach);
            is_same[i] = is_double_[i] &&
                         there.run_along(points_[i].position, way_at(i), kSameReach * reach);
        }
        forget_gaps(is_beside, kClosedGap * reach);
        forget_short_runs(is_double_, kShortestDouble * reach);
        forget_short_runs(is_same, kStepShare * reach / 2);
        for (int i = 0; i < kOverlap; ++i)
            shorten_runs();
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (is_same[i]) is_double_[i] = true;
    }

    void append_rest(std::vector<DrawnLine>& rest) const {
        if (std::find(is_double_.begin(), is_double_.end(), true) == is_double_.end()) {
            rest.push_back(line_);
            return;
        }
        DrawnLine part = with_points(line_, {});
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
    Vector2d way_at(std::size_t i) const {
        const std::size_t last = points_.size() - 1;
        return (points_[std::min(i + 1, last)].position - points_[i == 0 ? 0 : i - 1].position)
            .stableNormalized();
    }

    void forget_short_runs(std::vector<bool>& is_in, double shortest) const {
        for (auto begin = is_in.begin(); begin != is_in.end();) {
            const auto end = std::find(begin, is_in.end(), !*begin);
            if (*begin && length_between(begin - is_in.begin(), end - is_in.begin()) < shortest)
                std::fill(begin, end, false);
            begin = end;
        }
    }

    /// Between two lines that it doubles one after the other, a line stays if the gap is longer.
    void forget_gaps(const std::vector<bool>& is_beside, double longest) {
        const auto first = std::find(is_beside.begin(), is_beside.end(), true);
        for (auto begin = std::find(first, is_beside.end(), false); begin != is_beside.end();) {
            const auto end = std::find(begin, is_beside.end(), true);
            if (end == is_beside.end()) return;  // beyond the last one
            const auto from = begin - is_beside.begin(), to = end - is_beside.begin();
            if (length_between(from - 1, to) > longest)
                std::fill(is_double_.begin() + from, is_double_.begin() + to, false);
            begin = std::find(end, is_beside.end(), false);
        }
    }

    double length_between(std::ptrdiff_t begin, std::ptrdiff_t end) const {
        return length_of(points_, std::size_t(begin), std::size_t(end));
    }

    /// What is left ends beside the line that it doubled, without a gap.
    void shorten_runs() {
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

bool adds_nothing(const DrawnLine& line, const DrawnLines& there, double reach) {
    if (length_of(line.points) > 2 * kShortestDouble * reach) return false;
    for (const DrawnPoint& end : {line.points.front(), line.points.back()})
        if (!there.is_beside(end.position, reach)) return false;  // another line may end there
    const std::vector<DrawnPoint> points = refine(line.points, kStepShare * reach);
    const auto beside = std::count_if(points.begin(), points.end(), [&](const DrawnPoint& point) {
        return there.is_beside(point.position, kBesideReach * reach);
    });
    return double(beside) >= kMostBeside * double(points.size());
}

bool lies_on(const DrawnLines& there, const DrawnLine& line, double reach) {
    const std::vector<DrawnPoint> points = refine(line.points, kStepShare * reach);
    return std::all_of(points.begin(), points.end(), [&](const DrawnPoint& point) {
        return there.is_beside(point.position, kSameReach * reach);
    });
}

/// The higher classes first, of a class the longest.
std::vector<std::size_t> order_of(const std::vector<DrawnLine>& lines) {
    std::vector<double> lengths;
    for (const DrawnLine& line : lines)
        lengths.push_back(length_of(line.points));
    std::vector<std::size_t> order(lines.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const int of_a = rank_of(lines[a].line_class), of_b = rank_of(lines[b].line_class);
        return of_a != of_b ? of_a < of_b : lengths[a] > lengths[b];
    });
    return order;
}

/// Lines may be equal once ends are joined.
std::vector<DrawnLine> without_equal(const std::vector<DrawnLine>& lines, double reach) {
    DrawnLines there(reach);
    std::vector<bool> is_kept(lines.size());
    for (const std::size_t i : order_of(lines)) {
        is_kept[i] = lines[i].line_class == LineClass::Outline || !lies_on(there, lines[i], reach);
        if (is_kept[i]) there.add(positions_of(lines[i]));
    }
    std::vector<DrawnLine> rest;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (is_kept[i]) rest.push_back(lines[i]);
    return rest;
}

}  // namespace

std::vector<DrawnLine> without_doubles(std::vector<DrawnLine> lines, double reach) {
    for (DrawnLine& line : lines)
        if (line.points.size() > 2 && line.line_class != LineClass::Outline)
            line = JogRemoval(line, reach).result();
    DrawnLines there(reach);
    std::vector<DrawnLine> rest, left_out, parts;
    for (const std::size_t i : order_of(lines)) {
        if (lines[i].line_class == LineClass::Outline) {  // whole, whatever is beside them
            rest.push_back(lines[i]);
            there.add(positions_of(lines[i]));
            continue;
        }
        parts.clear();
        if (lines[i].points.size() > 1) LineCutter(lines[i], there, reach).append_rest(parts);
        const auto dropped = std::stable_partition(
            parts.begin(), parts.end(),
            [&](const DrawnLine& part) { return !adds_nothing(part, there, reach); });
        for (auto part = parts.begin(); part != dropped; ++part)
            there.add(positions_of(*part));
        rest.insert(rest.end(), parts.begin(), dropped);
        left_out.insert(left_out.end(), dropped, parts.end());
    }
    join_edges(rest, left_out, reach);
    return without_equal(rest, reach);
}

}  // namespace line_drawing
