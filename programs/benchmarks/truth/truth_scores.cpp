// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_measures.h"

#include <algorithm>

namespace benchmarks {

NearSegments::NearSegments(const PlaneLines& lines, double reach) : reach_(reach) {
    for (std::size_t l = 0; l < lines.size(); ++l) {
        double along = 0;
        for (std::size_t i = 0; i + 1 < lines[l].size(); ++i) {
            const PlanePoint span = lines[l][i + 1] - lines[l][i];
            add({lines[l][i], span, along, l});
            along += span.norm();
        }
    }
}

/// Adds pieces shorter than half a cell to the cells of their ends, so that the cells around a
/// point have all within reach.
void NearSegments::add(const Segment& segment) {
    const auto number = std::uint32_t(segments_.size());
    segments_.push_back(segment);
    const int pieces = 1 + int(segment.span.norm() / (0.5 * reach_));
    for (int k = 0; k <= pieces; ++k) {
        auto& cell = cells_[key(cell_of(segment.at(double(k) / pieces)))];
        if (cell.empty() || cell.back() != number) cell.push_back(number);
    }
}

double NearSegments::nearest_on(const Segment& segment, const PlanePoint& p) {
    const double square = segment.span.squaredNorm();
    return square > 0 ? std::clamp((p - segment.begin).dot(segment.span) / square, 0., 1.) : 0;
}

namespace {

constexpr double kStep = 0.1;             // mm, of the pieces that are looked at
constexpr double kClosingGap = 0.01;      // mm, between the ends of what counts as closed
constexpr double kJointGap = 0.05;        // mm, within which an end is at another path
constexpr double kTrueEndGap = 0.5;       // mm, within which an end is that of an exact line
constexpr double kOwnNeighbourhood = 1;   // mm of a path at its end that do not count as another
constexpr double kLeastCosine = 0.93969;  // of 20 degrees, between lines that run side by side

double length_of(const PlaneLine& line) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        length += (line[i + 1] - line[i]).norm();
    return length;
}

/// The share of the lines' length within the tolerance of the others; `far` gets the rest.
double share_near(const PlaneLines& lines, const PlaneLines& others, double tolerance,
                  PlaneLines& far) {
    const NearSegments near(others, tolerance);
    double length = 0, near_length = 0;
    for (const PlaneLine& line : lines)
        for_each_piece(line, kStep, [&](const PlanePoint& begin, const PlanePoint& end) {
            const bool is_near = near.has_near((begin + end) / 2);
            length += (end - begin).norm();
            if (is_near)
                near_length += (end - begin).norm();
            else
                far.push_back({begin, end});
        });
    return length > 0 ? near_length / length : 1;
}

/// Unit vector from the end into the line, over the end's neighbourhood.
PlanePoint direction_from_end(const PlaneLine& line, bool from_last) {
    const auto at = [&](std::size_t i) { return line[from_last ? line.size() - 1 - i : i]; };
    double left = kOwnNeighbourhood;
    std::size_t i = 1;
    for (; i + 1 < line.size() && left > (at(i) - at(i - 1)).norm(); ++i)
        left -= (at(i) - at(i - 1)).norm();
    return (at(i) - at(0)).stableNormalized();
}

/// Whether the place is near an end of a line that goes back the same way.
bool ends_in_direction(const PlaneLine& line, double along, const PlanePoint& direction) {
    const bool is_first = along <= kOwnNeighbourhood,
               is_last = along >= length_of(line) - kOwnNeighbourhood;
    return (is_first && direction_from_end(line, false).dot(direction) >= kLeastCosine) ||
           (is_last && direction_from_end(line, true).dot(direction) >= kLeastCosine);
}

/// Ends of required lines that no other required line continues: lines that end there run back
/// beside them, as at the tips of a circle seen nearly edge-on, which pens draw as one line.
PlaneLine true_ends(const PlaneLines& required) {
    const NearSegments near(required, kJointGap);
    PlaneLine ends;
    for (const PlaneLine& line : required) {
        if (line.size() < 2) continue;
        for (const bool is_last : {false, true}) {
            const PlanePoint& end = is_last ? line.back() : line.front();
            const PlanePoint direction = direction_from_end(line, is_last);
            const bool leads_on = near.any_near(end, [&](const NearPlace& place) {
                return !ends_in_direction(required[place.line], place.along, direction);
            });
            if (!leads_on) ends.push_back(end);
        }
    }
    return ends;
}

void score_ends(const PlaneLines& drawing, const PlaneLines& required, double slack,
                TruthScores& scores) {
    const NearSegments near(drawing, kJointGap);
    const PlaneLine known_ends = true_ends(required);
    const auto look = [&](const PlanePoint& p, std::size_t own, double own_along) {
        ++scores.ends;
        const bool is_joined = near.any_near(p, [&](const NearPlace& place) {
            return place.line != own || std::abs(place.along - own_along) > kOwnNeighbourhood;
        });
        const auto is_here = [&](const PlanePoint& end) {
            return (p - end).norm() <= kTrueEndGap + slack;
        };
        if (!is_joined && std::none_of(known_ends.begin(), known_ends.end(), is_here))
            scores.loose_ends.push_back(p);
    };
    for (std::size_t i = 0; i < drawing.size(); ++i) {
        const PlaneLine& line = drawing[i];
        if ((line.front() - line.back()).norm() < kClosingGap) continue;
        look(line.front(), i, 0);
        look(line.back(), i, length_of(line));
    }
}

}  // namespace

TruthScores score(const PlaneLines& drawing, const PlaneLines& required, const PlaneLines& allowed,
                  double tolerance, double slack) {
    TruthScores scores;
    PlaneLines exact = required;
    exact.insert(exact.end(), allowed.begin(), allowed.end());
    scores.recall = share_near(required, drawing, tolerance, scores.missed);
    scores.precision = share_near(drawing, exact, tolerance, scores.wrong);
    score_ends(drawing, required, slack, scores);
    return scores;
}

}  // namespace benchmarks
