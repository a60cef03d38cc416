// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

#include <algorithm>
#include <array>

#include "strokes/drawn_lines.h"
#include "strokes/refining.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

/// Whether a line may not move: an edge of the form, or a contour, which has been smoothed.
bool is_edge(const DrawnLine& line) {
    return line.line_class < LineClass::Inner && is_fixed(line);
}

class EndJoining {
public:
    EndJoining(std::vector<DrawnLine>& lines, double reach)
        : lines_(lines), reach_(reach), all_(all_of(lines, reach)) {}

    void bring_back(const std::vector<DrawnLine>& left_out) {
        DrawnLines loose(reach_);
        for (std::size_t i = 0; i < lines_.size(); ++i)
            for (const Vector2d& end : loose_ends(i))
                loose.add({end, end + Vector2d(kSameReach * reach_, 0)}, i);
        for (const DrawnLine& line : left_out)
            if (bridges(line, loose)) {
                all_.add(positions_of(line), lines_.size());
                lines_.push_back(line);
            }
    }

    void lead() {
        for (std::size_t i = 0; i < lines_.size(); ++i)
            for (const Vector2d& end : loose_ends(i))
                if (const auto place = all_.nearest_on(end, i, kBesideReach * reach_)) {
                    const Vector2d to = loose_end_near(*place, end).value_or(place->position);
                    if (!runs_back(i, end, to) ||
                        (is_edge(lines_[i]) && is_long(i) && !shorten(i, end, to)))
                        extend(i, end, to);
                }
    }

private:
    bool is_loose(std::size_t line, const Vector2d& end) const {
        return !all_.is_near(end, line, kSameReach * reach_);
    }

    /// Outlines are closed; sections may end where the surface does.
    std::vector<Vector2d> loose_ends(std::size_t i) const {
        const DrawnLine& line = lines_[i];
        std::vector<Vector2d> ends;
        if (line.closed || line.line_class == LineClass::Section) return ends;
        for (const DrawnPoint& end : {line.points.front(), line.points.back()})
            if (is_loose(i, end.position)) ends.push_back(end.position);
        return ends;
    }

    /// Whether a line leads from a loose end to another line.
    bool bridges(const DrawnLine& line, const DrawnLines& loose) const {
        const std::array<Vector2d, 2> ends = {line.points.front().position,
                                              line.points.back().position};
        for (int k = 0; k < 2; ++k) {
            const auto from = loose.nearest_on(ends[k], none, 2 * kSameReach * reach_);
            if (from && is_loose(from->line, from->position) &&
                all_.is_near(ends[1 - k], from->line, kBesideReach * reach_))
                return true;
        }
        return false;
    }

    /// A shorter line would vanish in the piece that joins it.
    bool is_long(std::size_t i) const {
        return length_of(lines_[i].points) > 2 * kBesideReach * reach_;
    }

    /// The line's own loose end near a place: one piece then joins both.
    std::optional<Vector2d> loose_end_near(const DrawnLines::Place& place,
                                           const Vector2d& from) const {
        for (const Vector2d& end : loose_ends(place.line))
            if ((end - from).norm() < kBesideReach * reach_) return end;
        return {};
    }

    /// Cuts the line back to a line that it has passed, if that leaves no white. Whether it did.
    bool shorten(std::size_t i, const Vector2d& end, const Vector2d& to) {
        std::vector<DrawnPoint>& points = lines_[i].points;
        const bool is_first = points.front().position == end;
        const Vector2d way = end - (is_first ? points[1] : points[points.size() - 2]).position;
        const Vector2d past = end - to;
        const double share = past.dot(way) / way.squaredNorm();
        if (!(share > 0 && share < 1) || (past - share * way).norm() > kSameReach * reach_)
            return false;
        (is_first ? points.front() : points.back()).position = to;
        return true;
    }

    /// Whether the line's own stroke is there already.
    bool runs_back(std::size_t i, const Vector2d& end, const Vector2d& to) const {
        const std::vector<DrawnPoint>& points = lines_[i].points;
        const bool is_first = points.front().position == end;
        const Vector2d before = (is_first ? points[1] : points[points.size() - 2]).position;
        return (to - end).normalized().dot((end - before).normalized()) < kReversal;
    }

    void extend(std::size_t i, const Vector2d& end, const Vector2d& to) {
        std::vector<DrawnPoint>& points = lines_[i].points;
        const bool is_first = points.front().position == end;
        DrawnPoint point = is_first ? points.front() : points.back();
        point = {to, point.weight, laplacian_lines::kNoNode, true, false, point.origin};
        points.insert(is_first ? points.begin() : points.end(), point);
        all_.add({end, to}, i);
    }

    static constexpr std::size_t none = std::size_t(-1);
    std::vector<DrawnLine>& lines_;
    const double reach_;
    DrawnLines all_;
};

// of inner lines, in pens
constexpr double kLongestHook = 6;  // 1.5 √h
constexpr double kLineReach = 4;    // over which directions before and after a bend are taken
constexpr double kSamePlace = 0.5;
constexpr double kStep = 0.5;

constexpr double kLongestLead = 3;
constexpr double kDirectionReach = 3;  // of an end
constexpr double kShiftReach = 4;      // over which a line follows its end
constexpr double kPointLength = 6;     // at most a third of the line

constexpr double kLongestFaintHook = 1 / 3.;  // of the line
constexpr double kFaint = 0.75;               // of the mean weight of the line before a hook
constexpr double kHookCosine = 0.5;           // of 60°
constexpr double kLeadCosine = 0.7;           // of 45°
constexpr double kLeastWeight = 0.5;          // of ends that are led on; fainter ones taper off

/// Whether what follows a point is fainter than what is before it.
bool is_faint(const std::vector<DrawnPoint>& points, std::size_t at) {
    const auto mean = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i)
            sum += points[i].weight;
        return sum / double(end - begin);
    };
    return mean(at, points.size()) < kFaint * mean(0, at);
}

/// The point from which the line bends aside most; the last one if it does not.
std::size_t begin_of_hook(const std::vector<DrawnPoint>& points, double pen) {
    const std::size_t last = points.size() - 1;
    const double longest = std::max(kLongestHook * pen, kLongestFaintHook * length_of(points));
    std::size_t begin = last;
    double least = kHookCosine, length = 0;
    for (std::size_t i = last - 1; i > 0; --i) {
        length += (points[i + 1].position - points[i].position).norm();
        if (length > longest) break;
        const auto distance = [&](std::size_t k) {
            return (points[k].position - points[i].position).norm();
        };
        std::size_t before = i, after = i;
        while (before > 0 && distance(before) < kLineReach * pen)
            --before;
        while (after < last && distance(after) < kLineReach * pen)
            ++after;
        const Vector2d along = (points[i].position - points[before].position).stableNormalized();
        const Vector2d hook = (points[after].position - points[i].position).stableNormalized();
        if (along.dot(hook) >= least) continue;
        if (length > kLongestHook * pen && !is_faint(points, i)) continue;
        least = along.dot(hook);
        begin = i;
    }
    return begin;
}

}  // namespace

void join_loose_ends(std::vector<DrawnLine>& lines, const std::vector<DrawnLine>& left_out,
                     double reach) {
    EndJoining joining(lines, reach);
    joining.bring_back(left_out);
    joining.lead();
}

void cut_hooks(std::vector<DrawnLine>& lines, double pen) {
    const DrawnLines all = all_of(lines, pen);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        DrawnLine& line = lines[i];
        if (!is_inner(line) || line.closed || length_of(line.points) < 2 * kLongestHook * pen)
            continue;
        std::vector<DrawnPoint> points = refine(line.points, kStep * pen);
        for (int end = 0; end < 2; ++end) {
            std::reverse(points.begin(), points.end());
            if (!all.is_near(points.back().position, i, kSamePlace * pen))
                points.resize(begin_of_hook(points, pen) + 1);
        }
        line.points = std::move(points);
    }
}

void point_ends(std::vector<DrawnLine>& lines, const Pens& pens) {
    const double pen = pens[std::size_t(LineClass::Inner)];
    const DrawnLines all = all_of(lines, pen);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        DrawnLine& line = lines[i];
        if (!is_on_curved(line)) continue;
        const bool is_contour = is_curved_contour(line);
        const double least = pens[std::size_t(LineClass::Fine)] /
                             (is_contour ? pens[std::size_t(LineClass::Contour)] : pen);
        const double length = length_of(line.points), third = length / 3;
        const auto is_loose = [&](const DrawnPoint& end) {
            return !line.closed && !all.is_near(end.position, i, kSamePlace * pen);
        };
        const bool begins = is_loose(line.points.front()), ends = is_loose(line.points.back());
        line.points = refine(line.points, pen);
        double at = 0;
        const DrawnPoint* before = &line.points.front();
        for (DrawnPoint& point : line.points) {
            at += (point.position - before->position).norm();
            before = &point;
            const double to_end = std::min(begins ? at : length, ends ? length - at : length);
            const double swelling = is_contour ? 1 : std::min(1., to_end / third);
            point.weight = std::min(1., to_end / std::min(kPointLength * pen, third)) *
                           std::max(swelling * point.weight, least);
        }
    }
}

std::vector<MetEnd> join_ends(std::vector<DrawnLine>& lines, double pen) {
    const DrawnLines all = all_of(lines, kLongestLead * pen);
    std::vector<MetEnd> met;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<DrawnPoint>& points = lines[i].points;
        if (!is_inner(lines[i]) || lines[i].closed || points.size() < 2) continue;
        for (const bool is_last : {false, true}) {
            const DrawnPoint end = is_last ? points.back() : points.front();
            const auto place = all.nearest_on(end.position, i, kLongestLead * pen);
            if (!place) continue;
            const Vector2d way = place->position - end.position;
            if (way.norm() > kSamePlace * pen) {
                const Vector2d outwards = outwards_at(points, is_last, kDirectionReach * pen);
                if (end.weight < kLeastWeight || outwards.dot(way) < kLeadCosine * way.norm())
                    continue;
                points.insert(is_last ? points.end() : points.begin(),
                              {place->position, end.weight, end.node, false, false, end.origin});
            }
            met.push_back({i, is_last, place->line});
        }
    }
    return met;
}

void follow_met(const std::vector<MetEnd>& ends, double pen, std::vector<DrawnLine>& lines) {
    const DrawnLines all = all_of(lines, kLongestLead * pen);
    for (const MetEnd& end : ends) {
        std::vector<DrawnPoint>& points = lines[end.line].points;
        const Vector2d at = (end.is_last ? points.back() : points.front()).position;
        const auto place = all.nearest_on(at, end.line, pen);
        if (place && place->line == end.met)
            shift_end(points, end.is_last, place->position - at, kShiftReach * pen);
    }
}

}  // namespace line_drawing
