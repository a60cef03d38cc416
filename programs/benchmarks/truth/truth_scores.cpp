// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_scores.h"

#include "plane_lines.h"

namespace benchmarks {
namespace {

constexpr double step = 0.1;             // mm, of the pieces that are looked at
constexpr double double_gap = 0.1;       // mm, within which a line doubles another
constexpr double double_turn = 20;       // degrees between such lines
constexpr double joint_gap = 0.05;       // mm, within which an end is at another path
constexpr double true_end_gap = 0.5;     // mm, within which an end is that of an exact line
constexpr double own_neighbourhood = 1;  // mm of a path beside its end that are no other line

class Runs {
public:
    Runs(Mistake mistake, TruthDetails* details) : mistake_(mistake), details_(details) {}

    void note(const PlanePoint& middle, const PlanePoint& direction, double length,
              bool is_mistaken) {
        if (!is_mistaken) return end();
        if (run_.empty()) run_.push_back(middle - direction * (length / 2));
        run_.push_back(middle + direction * (length / 2));
        length_ += length;
        longest = std::max(longest, length_);
    }
    void end() {
        if (details_ && run_.size() > 1) details_->parts.push_back({mistake_, run_});
        run_.clear();
        length_ = 0;
    }

    double longest = 0;

private:
    Mistake mistake_;
    TruthDetails* details_;
    PlaneLine run_;
    double length_ = 0;
};

void score_recall(const PlaneLines& demanded, const NearSegments& drawing, double tolerance,
                  TruthScores& scores, TruthDetails* details) {
    Runs runs(Mistake::Missed, details);
    for (const PlaneLine& line : demanded) {
        for_each_piece(line, step, [&](const PlanePoint& p, const PlanePoint& way, double length) {
            const bool is_found = drawing.distance(p) <= tolerance;
            scores.demanded += length;
            if (is_found) scores.found += length;
            runs.note(p, way, length, !is_found);
        });
        runs.end();
    }
    if (details) details->longest_missed = runs.longest;
}

void score_precision(const DrawnPaths& drawing, const NearSegments& exact, double tolerance,
                     TruthScores& scores, TruthDetails* details) {
    Runs runs(Mistake::Wrong, details);
    for (const DrawnPath& path : drawing) {
        for_each_piece(path.points, step,
                       [&](const PlanePoint& p, const PlanePoint& way, double length) {
                           const double distance = exact.distance(p);
                           const bool is_right = distance <= tolerance;
                           scores.drawn += length;
                           if (is_right) scores.right += length;
                           if (is_right) scores.squares += distance * distance * length;
                           runs.note(p, way, length, !is_right);
                       });
        runs.end();
    }
    if (details) details->longest_wrong = runs.longest;
}

void score_doubles(const DrawnPaths& drawing, const PlaneLines& lines, TruthScores& scores,
                   TruthDetails* details) {
    const NearSegments near(lines, double_gap);
    const double least_cosine = std::cos(double_turn * M_PI / 180);
    Runs runs(Mistake::Doubled, details);
    for (std::size_t i = 0; i < drawing.size(); ++i) {
        for_each_piece(lines[i], step,
                       [&](const PlanePoint& p, const PlanePoint& way, double length) {
                           const bool is_double = near.any_near(p, [&](const NearPlace& place) {
                               return place.line != i && !place.is_end &&
                                      std::abs(place.direction.dot(way)) >= least_cosine;
                           });
                           if (is_double) scores.doubled += length;
                           runs.note(p, way, length, is_double);
                       });
        runs.end();
    }
}

/// Whether another line, or a farther part of the same one, is within reach.
bool is_at_line(const NearSegments& lines, const PlanePoint& p, std::size_t own, double own_along) {
    return lines.any_near(p, [&](const NearPlace& place) {
        return place.line != own || std::abs(place.along - own_along) > own_neighbourhood;
    });
}

/// Unit vector from the end into the line, over the end's neighbourhood.
PlanePoint way_back(const PlaneLine& line, bool from_last) {
    const auto at = [&](std::size_t i) { return line[from_last ? line.size() - 1 - i : i]; };
    double left = own_neighbourhood;
    std::size_t i = 1;
    for (; i + 1 < line.size() && left > (at(i) - at(i - 1)).norm(); ++i)
        left -= (at(i) - at(i - 1)).norm();
    return (at(i) - at(0)).stableNormalized();
}

/// Whether the place is near an end of a line that goes back the same way.
bool ends_alike(const PlaneLine& line, double along, const PlanePoint& way) {
    const double least_cosine = std::cos(double_turn * M_PI / 180);
    const bool is_first = along <= own_neighbourhood,
               is_last = along >= length_of(line) - own_neighbourhood;
    return (is_first && way_back(line, false).dot(way) >= least_cosine) ||
           (is_last && way_back(line, true).dot(way) >= least_cosine);
}

/// Ends of exact lines that nothing continues: others that end there run back beside them, as at
/// the tips of a circle seen nearly edge-on, which pens draw as one line.
PlaneLine true_ends(const PlaneLines& exact) {
    const NearSegments near(exact, joint_gap);
    PlaneLine ends;
    for (const PlaneLine& line : exact) {
        if (line.size() < 2) continue;
        for (const bool is_last : {false, true}) {
            const PlanePoint& end = is_last ? line.back() : line.front();
            const PlanePoint way = way_back(line, is_last);
            const bool leads_on = near.any_near(end, [&](const NearPlace& place) {
                return !ends_alike(exact[place.line], place.along, way);
            });
            if (!leads_on) ends.push_back(end);
        }
    }
    return ends;
}

void score_ends(const DrawnPaths& drawing, const PlaneLines& lines, const PlaneLines& exact,
                double slack, TruthScores& scores, TruthDetails* details) {
    const NearSegments near(lines, joint_gap);
    const PlaneLine ends_of_exact = true_ends(exact);
    const auto is_true = [&](const PlanePoint& p) {
        return std::any_of(ends_of_exact.begin(), ends_of_exact.end(), [&](const PlanePoint& end) {
            return (p - end).norm() <= true_end_gap + slack;
        });
    };
    const auto look = [&](const PlanePoint& p, std::size_t own, double along) {
        ++scores.ends;
        if (is_at_line(near, p, own, along) || is_true(p)) return;
        ++scores.loose_ends;
        if (details) details->loose_ends.push_back(p);
    };
    for (std::size_t i = 0; i < drawing.size(); ++i) {
        if (drawing[i].is_closed) continue;
        look(lines[i].front(), i, 0);
        look(lines[i].back(), i, length_of(lines[i]));
    }
}

}  // namespace

void TruthScores::add(const TruthScores& other) {
    demanded += other.demanded;
    found += other.found;
    drawn += other.drawn;
    right += other.right;
    squares += other.squares;
    doubled += other.doubled;
    ends += other.ends;
    loose_ends += other.loose_ends;
    outlines += other.outlines;
    closed_outlines += other.closed_outlines;
}

TruthScores score(const DrawnPaths& drawing, const ExactLines& exact, double tolerance,
                  double slack, TruthDetails* details) {
    TruthScores scores;
    const PlaneLines lines = lines_of(drawing);
    PlaneLines all_exact = exact.demanded;
    all_exact.insert(all_exact.end(), exact.allowed.begin(), exact.allowed.end());
    score_recall(exact.demanded, NearSegments(lines, tolerance), tolerance, scores, details);
    score_precision(drawing, NearSegments(all_exact, tolerance), tolerance, scores, details);
    score_doubles(drawing, lines, scores, details);
    score_ends(drawing, lines, exact.demanded, slack, scores, details);
    for (const DrawnPath& path : drawing) {
        scores.outlines += path.is_outline;
        scores.closed_outlines += path.is_outline && path.is_closed;
    }
    return scores;
}

}  // namespace benchmarks
