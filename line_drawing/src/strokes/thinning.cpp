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
constexpr double kBetweenLines = 3;  // from middle to middle: two pens of white, as in ISO 128
constexpr double kLeastWhite = 0.5;  // beside outlines
// A part of a line needs so much more at one place: what runs along an outline all the way goes.
constexpr double kClearWhite = 1;
constexpr double kLeastApart = 0.5;  // of a line, with white beside stronger ones
constexpr double kLowStep = 4;       // in depth: what is behind it is of the same form
constexpr double kShortestStroke = 6;
constexpr double kLeastExtent = 4;    // a √h: what is folded within it is a knot
constexpr double kLeastInk = 6;       // mean weight times length
constexpr double kShortestLoop = 24;  // 6 √h
constexpr double kLeastHole = 2;      // of a surface: smaller ones would be dots
constexpr double kLongestCrossing = 7.5, kLongestNearPass = 5;  // at another line, or near one
constexpr double kLongestTouch = 3, kLongestNearEnd = 2;        // likewise, of an end
constexpr double kSamePlace = 0.2, kMeeting = 2;
// If less than this share of a line is free, parts shorter than that are dropped as islands.
constexpr double kLongestIsland = 24, kLeastShare = 0.5;
constexpr double kStep = 0.2;

double mean_weight(const DrawnLine& line) {
    double sum = 0;
    for (const DrawnPoint& point : line.points)
        sum += point.weight;
    return sum / double(line.points.size());
}

double strength_of(const DrawnLine& line) {
    return mean_weight(line) * std::sqrt(length_of(line.points));
}

void sort_by_strength(std::vector<DrawnLine>& lines) {
    std::stable_sort(lines.begin(), lines.end(), [](const DrawnLine& a, const DrawnLine& b) {
        return strength_of(a) > strength_of(b);
    });
}

/// Whether a line is of the form, not of its curvature.
bool is_of_form(const DrawnLine& line) {
    return !is_on_curved(line) && line.line_class != LineClass::Hidden;
}

/// Whether an edge of the form, or of a low step, has others on both sides along half of it, with
/// less than the least white between: of grooves, threads and knurls at a small scale.
bool is_crowded(const DrawnLine& line, std::size_t number, const DrawnLines& edges,
                const Pens& pens) {
    const double pen = pens[std::size_t(LineClass::Inner)],
                 within = pens[std::size_t(line.line_class)] + kLeastWhite * pen;
    const bool is_step = line.line_class == LineClass::Contour && line.jump < kLowStep * pen;
    return (line.line_class == LineClass::Edge || is_step) &&
           share_between(line, number, edges, within) >= kLeastApart;
}

/// The middle of the longest run of true in a ring, which ends with a copy of its first element.
std::size_t freest_place(const std::vector<bool>& ring) {
    const std::size_t count = ring.size() - 1;
    std::size_t place = 0, longest = 0, run = 0;
    for (std::size_t i = 0; i < 2 * count; ++i) {
        run = ring[i % count] ? run + 1 : 0;
        if (run > longest) longest = run, place = (i - run / 2) % count;
    }
    return place;
}

class Thinning {
public:
    explicit Thinning(const Pens& pens)
        : pens_(pens), pen_(pens[std::size_t(LineClass::Inner)]), kept_(kBetweenLines * pen_) {
        for (const double pen : pens)
            outlines_.emplace_back(white_beside(pen));
    }

    void add_outline(const DrawnLine& line) {
        outlines_[std::size_t(line.line_class)].add(positions_of(line));
    }

    /// Adds a contour if at least half of it has white beside stronger lines; whether it did.
    bool add_contour(const DrawnLine& line) {
        return add_if_apart(line, [&](const Vector2d& point, double more) {
            return is_beside(LineClass::Outline, point, more) ||
                   is_beside(LineClass::Contour, point, more);
        });
    }

    /// Likewise a crowded edge, beside all lines.
    bool add_crowded(const DrawnLine& line) {
        return add_if_apart(
            line, [&](const Vector2d& point, double more) { return !is_beside_none(point, more); });
    }

    /// Adds the free parts of an inner line; whether that is all of it.
    bool add_free(const DrawnLine& line, std::vector<DrawnLine>& result) {
        if (line.closed && length_of(line.points) < kShortestLoop * pen_) return false;
        std::vector<DrawnPoint> points = refine(line.points, kStep * pen_);
        std::vector<bool> are_free(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            are_free[i] = is_free(points[i].position);
        const auto begin_ring_at = [&](std::size_t place) {
            begin_at(place, points);
            begin_at(place, are_free);
        };
        if (line.closed) begin_ring_at(freest_place(are_free));  // where nothing is to be bridged
        bridge(points, are_free);
        const auto covered = std::find(are_free.begin(), are_free.end(), false);
        if (line.closed && covered != are_free.end())
            begin_ring_at(std::size_t(covered - are_free.begin()));
        const double shortest =
            share_of(points, are_free) < kLeastShare ? kLongestIsland : kShortestStroke;
        for (std::size_t begin = 0; begin < points.size();) {
            std::size_t end = begin;
            while (end < points.size() && are_free[end])
                ++end;
            const auto is_clear = [&](const DrawnPoint& p) {
                return is_beside_none(p.position, kClearWhite * pen_);
            };
            const bool is_apart = std::any_of(points.begin() + std::ptrdiff_t(begin),
                                              points.begin() + std::ptrdiff_t(end), is_clear);
            if (is_apart && end - begin == points.size()) return keep(line, shortest, result);
            if (is_apart && end > begin + 1)
                keep(with_points(line, {points.begin() + std::ptrdiff_t(begin),
                                        points.begin() + std::ptrdiff_t(end)}),
                     shortest, result);
            begin = std::max(end, begin + 1);
        }
        return false;
    }

private:
    /// Not counting the ends of a line, which may meet others. is_beside(point, more): whether
    /// lines are nearer than inner lines may be, and `more` mm.
    template <class IsBeside>
    bool add_if_apart(const DrawnLine& line, IsBeside is_beside) {
        const double pen = pens_[std::size_t(line.line_class)];
        const double end = line.closed ? 0 : white_beside(pen), length = length_of(line.points);
        double at = 0, middle = 0, apart = 0;
        const std::vector<DrawnPoint> points = refine(line.points, kStep * pen_);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double piece = (points[i].position - points[i - 1].position).norm();
            at += piece;
            if (std::min(at, length - at) < end) continue;
            middle += piece;
            if (!is_beside(points[i].position, (pen - pen_) / 2)) apart += piece;
        }
        const bool stays = apart >= kLeastApart * middle;
        if (stays) add_outline(line);
        return stays;
    }

    double white_beside(double pen) const { return pen / 2 + (0.5 + kLeastWhite) * pen_; }

    bool is_free(const Vector2d& point) const {
        return !kept_.is_beside(point, kBetweenLines * pen_) && is_beside_none(point, 0);
    }

    /// Of the outlines; `more`: mm beyond what inner lines keep to.
    bool is_beside_none(const Vector2d& point, double more) const {
        for (std::size_t c = 0; c < kLineClassCount; ++c)
            if (is_beside(LineClass(c), point, more)) return false;
        return true;
    }

    bool is_beside(LineClass c, const Vector2d& point, double more) const {
        const auto number = std::size_t(c);
        return outlines_[number].is_beside(point, white_beside(pens_[number]) + more);
    }

    static double share_of(const std::vector<DrawnPoint>& points,
                           const std::vector<bool>& are_free) {
        double length = 0, free = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double piece = (points[i].position - points[i - 1].position).norm();
            length += piece;
            if (are_free[i - 1] && are_free[i]) free += piece;
        }
        return free / length;
    }

    bool touches(const Vector2d& point) const {
        return kept_.is_beside(point, kSamePlace * pen_) ||
               std::any_of(outlines_.begin(), outlines_.end(), [&](const DrawnLines& lines) {
                   return lines.is_beside(point, kSamePlace * pen_);
               });
    }

    /// Frees the end of a line, from its middle outwards, up to the next line.
    template <class Points, class Free>
    void free_up_to_touch(Points begin, Points end, Free is_free) const {
        for (; begin != end; ++begin) {
            *is_free++ = true;
            if (touches(begin->position)) return;
        }
    }

    /// Where lines only cross or meet, nothing is removed.
    void bridge(const std::vector<DrawnPoint>& points, std::vector<bool>& are_free) const {
        for (std::size_t begin = 0; begin < points.size();) {
            const auto from = std::ptrdiff_t(begin),
                       to = std::find(are_free.begin() + from, are_free.end(), true) -
                            are_free.begin(),
                       rest = std::ptrdiff_t(points.size()) - to;
            const auto end = std::size_t(to);
            const double length = length_of(points, begin, end);
            const bool is_first = begin == 0, is_last = rest == 0;
            const bool meets =
                std::any_of(points.begin() + from, points.begin() + to,
                            [&](const DrawnPoint& point) { return touches(point.position); });
            if (is_first != is_last && length < (meets ? kLongestTouch : kLongestNearEnd) * pen_) {
                if (is_last)
                    free_up_to_touch(points.begin() + from, points.end(), are_free.begin() + from);
                else
                    free_up_to_touch(points.rbegin() + rest, points.rend(),
                                     are_free.rbegin() + rest);
            } else if (!is_first && !is_last &&
                       length < (meets ? kLongestCrossing : kLongestNearPass) * pen_) {
                std::fill(are_free.begin() + from, are_free.begin() + to, true);
            }
            begin = std::max(end, begin + 1);
        }
    }

    bool keep(const DrawnLine& line, double shortest, std::vector<DrawnLine>& result) {
        const double length = length_of(line.points) / pen_;
        if (length < shortest || mean_weight(line) * length < kLeastInk ||
            box_of(line).diagonal().norm() < kLeastExtent * pen_ ||
            is_between_folds(line, kept_, pen_))
            return false;
        kept_.add(positions_of(line));
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
bool is_repeated(const std::vector<DrawnPoint>& line, const DrawnLines& all,
                 const std::vector<double>& lengths, std::size_t number) {
    const double length = lengths[number];
    const auto is_other_kind = [&](std::size_t i) {
        return i == number || lengths[i] < length / 2 || lengths[i] > 2 * length;
    };
    const Vector2d way = (line.back().position - line.front().position).stableNormalized();
    const Vector2d side = right_of(way), middle = line[line.size() / 2].position;
    return all.next_on(middle, side, {0, length}, is_other_kind) ||
           all.next_on(middle, -side, {0, length}, is_other_kind);
}

bool is_dot(const DrawnLine& line, double pen) {
    return line.kind == laplacian_lines::LineKind::Border && line.closed &&
           box_of(line).diagonal().norm() < kLeastHole * pen;
}

}  // namespace

std::vector<DrawnLine> without_fragments(std::vector<DrawnLine> lines, double shortest,
                                         double pen) {
    const DrawnLines all = all_of(lines, shortest);
    std::vector<double> lengths;
    for (const DrawnLine& line : lines)  // a ring goes there and back
        lengths.push_back(length_of(line.points) / (line.closed ? 2 : 1));
    std::vector<DrawnLine> rest;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::vector<DrawnPoint>& points = lines[i].points;
        const auto met_at = [&](const DrawnPoint& end) {
            return all.nearest_on(end.position, i, kMeeting * pen);
        };
        const auto stays = [&] {
            const auto first = met_at(points.front()), last = met_at(points.back());
            const bool is_contour = is_curved_contour(lines[i]);
            if (is_contour && lengths[i] < kShortestStroke * pen)
                return first && last && first->line != last->line &&
                       !is_inner(lines[first->line]) && !is_inner(lines[last->line]);
            return first || last || (!is_contour && is_repeated(points, all, lengths, i));
        };
        const bool is_fragment = is_on_curved(lines[i]) && lengths[i] < shortest && !stays();
        if (!is_fragment && !is_dot(lines[i], pen)) rest.push_back(lines[i]);
    }
    return rest;
}

std::vector<DrawnLine> thin_out(std::vector<DrawnLine> lines, const Pens& pens) {
    const double pen = pens[std::size_t(LineClass::Inner)];
    DrawnLines edges(kBetweenLines * pen);
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (is_of_form(lines[i])) edges.add(positions_of(lines[i]), i);
    Thinning thinning(pens);
    std::vector<DrawnLine> result, crowded, contours, inner;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<DrawnLine>& group = is_inner(lines[i])                     ? inner
                                        : is_curved_contour(lines[i])          ? contours
                                        : is_crowded(lines[i], i, edges, pens) ? crowded
                                                                               : result;
        if (&group == &result && is_of_form(lines[i])) thinning.add_outline(lines[i]);
        group.push_back(std::move(lines[i]));
    }
    sort_by_strength(crowded);
    for (DrawnLine& line : crowded)
        if (thinning.add_crowded(line)) result.push_back(std::move(line));
    sort_by_strength(contours);
    for (DrawnLine& line : contours)
        if (thinning.add_contour(line)) result.push_back(std::move(line));
    sort_by_strength(inner);
    std::vector<double> strengths;
    for (const DrawnLine& line : inner)
        strengths.push_back(strength_of(line));
    for_each_by_families(inner, strengths, kBetweenLines * pen,
                         [&](std::size_t i) { return thinning.add_free(inner[i], result); });
    return result;
}

}  // namespace line_drawing
