// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

#include <algorithm>
#include <cmath>

#include "strokes/drawn_lines.h"
#include "strokes/refining.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

// in pens of inner lines
constexpr double between_lines = 3;  // from middle to middle: two pens of white, as in ISO 128
constexpr double least_white = 0.5;  // beside outlines
// A part of a line has this much more white somewhere: what runs along an outline about as near as
// that is left out whole, not where it happens to be nearer.
constexpr double clear_white = 1;
constexpr double shortest_stroke = 6;
constexpr double least_extent = 4;    // √h: what is folded within it is a knot
constexpr double least_ink = 6;       // mean weight times length
constexpr double shortest_loop = 24;  // 6 √h
constexpr double longest_crossing = 7.5, longest_near_pass = 5;  // at another line, or near one
constexpr double longest_touch = 3, longest_near_end = 2;        // likewise, of an end
constexpr double same_place = 0.2, meeting = 2;
/// Remains of a fold are an island between others, unless this long or this share of it.
constexpr double longest_island = 24, least_share = 0.5;
constexpr double step = 0.2;

double meanWeight(const DrawnLine& line) {
    double sum = 0;
    for (const DrawnPoint& point : line.points)
        sum += point.weight;
    return sum / double(line.points.size());
}

double extentOf(const DrawnLine& line) {
    Eigen::AlignedBox2d box;
    for (const DrawnPoint& point : line.points)
        box.extend(point.position);
    return box.diagonal().norm();
}

double strengthOf(const DrawnLine& line) {
    return meanWeight(line) * std::sqrt(lengthOf(line.points));
}

void sortByStrength(std::vector<DrawnLine>& lines) {
    std::stable_sort(lines.begin(), lines.end(), [](const DrawnLine& a, const DrawnLine& b) {
        return strengthOf(a) > strengthOf(b);
    });
}

class Thinning {
public:
    explicit Thinning(const Pens& pens)
        : pens_(pens), pen_(pens[std::size_t(LineClass::Inner)]), kept_(between_lines * pen_) {
        for (const double pen : pens)
            outlines_.emplace_back(whiteBeside(pen));
    }

    void addOutline(const DrawnLine& line) {
        outlines_[std::size_t(line.line_class)].add(positionsOf(line));
    }

    /// Unless less than half of a contour has white beside stronger lines, not counting its ends,
    /// which may meet these.
    bool addContour(const DrawnLine& line) {
        const double pen = pens_[std::size_t(LineClass::Contour)];
        const double end = line.closed ? 0 : whiteBeside(pen), length = lengthOf(line.points);
        const double more = (pen - pen_) / 2;
        double at = 0, middle = 0, apart = 0;
        const std::vector<DrawnPoint> points = refine(line.points, step * pen_);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double piece = (points[i].position - points[i - 1].position).norm();
            at += piece;
            if (std::min(at, length - at) < end) continue;
            middle += piece;
            if (!isBeside(LineClass::Outline, points[i].position, more) &&
                !isBeside(LineClass::Contour, points[i].position, more))
                apart += piece;
        }
        const bool stays = apart >= least_share * middle;
        if (stays) addOutline(line);
        return stays;
    }

    /// Whether all of it was added.
    bool addFree(const DrawnLine& line, std::vector<DrawnLine>& result) {
        if (line.closed && lengthOf(line.points) < shortest_loop * pen_) return false;
        const std::vector<DrawnPoint> points = refine(line.points, step * pen_);
        std::vector<bool> is_free(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            is_free[i] = isFree(points[i].position);
        bridge(points, is_free);
        const double shortest =
            shareOf(points, is_free) < least_share ? longest_island : shortest_stroke;
        for (std::size_t begin = 0; begin < points.size();) {
            std::size_t end = begin;
            while (end < points.size() && is_free[end])
                ++end;
            const auto is_clear = [&](const DrawnPoint& p) {
                return isBesideNone(p.position, clear_white * pen_);
            };
            const bool is_apart = std::any_of(points.begin() + std::ptrdiff_t(begin),
                                              points.begin() + std::ptrdiff_t(end), is_clear);
            if (is_apart && end - begin == points.size()) return keep(line, shortest, result);
            if (is_apart && end > begin + 1)
                keep({line.line_class,
                      false,
                      {points.begin() + std::ptrdiff_t(begin),
                       points.begin() + std::ptrdiff_t(end)}},
                     shortest, result);
            begin = std::max(end, begin + 1);
        }
        return false;
    }

private:
    double whiteBeside(double pen) const { return pen / 2 + (0.5 + least_white) * pen_; }

    bool isFree(const Vector2d& point) const {
        return !kept_.isBeside(point, between_lines * pen_) && isBesideNone(point, 0);
    }

    /// Of the outlines; `more`: mm beyond what inner lines keep to.
    bool isBesideNone(const Vector2d& point, double more) const {
        for (std::size_t c = 0; c < line_class_count; ++c)
            if (isBeside(LineClass(c), point, more)) return false;
        return true;
    }

    bool isBeside(LineClass c, const Vector2d& point, double more) const {
        const auto number = std::size_t(c);
        return outlines_[number].isBeside(point, whiteBeside(pens_[number]) + more);
    }

    static double shareOf(const std::vector<DrawnPoint>& points, const std::vector<bool>& is_free) {
        double length = 0, free = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double piece = (points[i].position - points[i - 1].position).norm();
            length += piece;
            if (is_free[i - 1] && is_free[i]) free += piece;
        }
        return free / length;
    }

    bool touches(const Vector2d& point) const {
        return kept_.isBeside(point, same_place * pen_) ||
               std::any_of(outlines_.begin(), outlines_.end(), [&](const DrawnLines& lines) {
                   return lines.isBeside(point, same_place * pen_);
               });
    }

    /// Extends an end, away from the middle of its line, to the next line.
    template <class Points, class Free>
    void freeUpToTouch(Points begin, Points end, Free is_free) const {
        for (; begin != end; ++begin) {
            *is_free++ = true;
            if (touches(begin->position)) return;
        }
    }

    /// Where lines only cross or meet, nothing is removed.
    void bridge(const std::vector<DrawnPoint>& points, std::vector<bool>& is_free) const {
        for (std::size_t begin = 0; begin < points.size();) {
            std::size_t end = begin;
            double length = 0;
            while (end < points.size() && !is_free[end]) {
                if (end > begin) length += (points[end].position - points[end - 1].position).norm();
                ++end;
            }
            const auto from = std::ptrdiff_t(begin), to = std::ptrdiff_t(end),
                       rest = std::ptrdiff_t(points.size()) - to;
            const bool is_first = begin == 0, is_last = rest == 0;
            const bool meets =
                std::any_of(points.begin() + from, points.begin() + to,
                            [&](const DrawnPoint& point) { return touches(point.position); });
            if (is_first != is_last && length < (meets ? longest_touch : longest_near_end) * pen_) {
                if (is_last)
                    freeUpToTouch(points.begin() + from, points.end(), is_free.begin() + from);
                else
                    freeUpToTouch(points.rbegin() + rest, points.rend(), is_free.rbegin() + rest);
            } else if (!is_first && !is_last &&
                       length < (meets ? longest_crossing : longest_near_pass) * pen_) {
                std::fill(is_free.begin() + from, is_free.begin() + to, true);
            }
            begin = std::max(end, begin + 1);
        }
    }

    bool keep(const DrawnLine& line, double shortest, std::vector<DrawnLine>& result) {
        const double length = lengthOf(line.points) / pen_;
        if (length < shortest || meanWeight(line) * length < least_ink ||
            extentOf(line) < least_extent * pen_ || isBetweenFolds(line, kept_, pen_))
            return false;
        kept_.add(positionsOf(line));
        result.push_back(line);
        return true;
    }

    const Pens& pens_;
    const double pen_;
    std::vector<DrawnLines> outlines_;  // by class
    DrawnLines kept_;
};

/// Whether a like stroke lies beside a line, no farther away than it is long: both are of a
/// texture.
bool isRepeated(const std::vector<DrawnPoint>& line, const DrawnLines& all,
                const std::vector<double>& lengths, std::size_t number) {
    const double length = lengths[number];
    const auto is_other_kind = [&](std::size_t i) {
        return i == number || lengths[i] < length / 2 || lengths[i] > 2 * length;
    };
    const Vector2d way = (line.back().position - line.front().position).stableNormalized();
    const Vector2d side(-way.y(), way.x()), middle = line[line.size() / 2].position;
    return all.nextOn(middle, side, {0, length}, is_other_kind) ||
           all.nextOn(middle, -side, {0, length}, is_other_kind);
}

}  // namespace

std::vector<DrawnLine> withoutFragments(std::vector<DrawnLine> lines, double shortest, double pen) {
    const DrawnLines all = allOf(lines, shortest);
    std::vector<double> lengths;
    for (const DrawnLine& line : lines)  // a ring goes there and back
        lengths.push_back(lengthOf(line.points) / (line.closed ? 2 : 1));
    std::vector<DrawnLine> rest;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::vector<DrawnPoint>& points = lines[i].points;
        const auto meets = [&](const DrawnPoint& end) {
            return all.isNear(end.position, i, meeting * pen);
        };
        if (!isOnCurved(lines[i]) || lengths[i] >= shortest || meets(points.front()) ||
            meets(points.back()) || (isInner(lines[i]) && isRepeated(points, all, lengths, i)))
            rest.push_back(lines[i]);
    }
    return rest;
}

std::vector<DrawnLine> thinOut(std::vector<DrawnLine> lines, const Pens& pens) {
    Thinning thinning(pens);
    std::vector<DrawnLine> result, contours, inner;
    for (DrawnLine& line : lines) {
        const bool is_curved = isCurvedContour(line);
        if (line.line_class != LineClass::Hidden && !isInner(line) && !is_curved)
            thinning.addOutline(line);
        (isInner(line) ? inner : is_curved ? contours : result).push_back(std::move(line));
    }
    sortByStrength(contours);
    for (DrawnLine& line : contours)
        if (thinning.addContour(line)) result.push_back(std::move(line));
    sortByStrength(inner);
    std::vector<double> strengths;
    for (const DrawnLine& line : inner)
        strengths.push_back(strengthOf(line));
    forEachByFamilies(inner, strengths, between_lines * pens[std::size_t(LineClass::Inner)],
                      [&](std::size_t i) { return thinning.addFree(inner[i], result); });
    return result;
}

}  // namespace line_drawing
