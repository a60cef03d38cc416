// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/line_decision.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "visibility/chain_labels.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;

// In D unless something else is said.
constexpr double kSpacing = 0.003;  // of rays along a line
/// A ray of a contour: where it begins beside it in the picture, where it passes the contour's own
/// surface, in mean edges, and how much nearer to the eye, in clearances.
struct ContourRay {
    double aside, towards_eye;
};
constexpr ContourRay kContourRays[] = {{0.05, 0.1}, {0.2, 0.3}, {0.5, 1}};
constexpr double kFarthestAside = 0.0015;
// How far beside a contour, and before and behind it, its surface is looked for.
constexpr double kSideAside = 0.0007, kSideReach = 0.05;
constexpr double kInside = 0.002;  // below the surface
// What a change of sight costs, in lengths of wrong votes: where an outline passes before a line or
// at a cusp; elsewhere on contours; elsewhere on other lines.
constexpr double kCrossingCost = 0.001, kContourCost = 0.02, kLineCost = 0.0015;
// What it costs to call a contour bent the other way: the second in mean edges.
constexpr double kCuspCost = 0.002, kCuspEdges = 2;
// A fold that is no longer than this has to run back between so many pieces at either end.
constexpr double kLongestFalseFold = 0.05;
constexpr std::size_t kPiecesAround = 3;
constexpr int kSideVotes = 32;  // on a line
constexpr int kBisections = 8;

/// Votes on the pieces of one line.
class Voting {
public:
    Voting(const LineSet& lines, const Polyline& line, int side, const SightLengths& lengths,
           Sight& sight)
        : lines_(lines), line_(line), side_(side), lengths_(lengths), sight_(sight) {}

    Vector3d place(const LinePlace& at) const {
        return point_at(lines_, line_, at).position.cast<double>();
    }
    /// To the free side of a contour, as long as the piece is in the picture; to the right where
    /// that side is not known.
    Vector3d across(const LinePiece& piece, const Vector3d& at) const {
        const Vector3d way = place(piece.end) - place(piece.begin);
        return (side_ < 0 ? -1 : 1) * way.cross(sight_.towards_eye(at));
    }
    LinePlace middle_place(const LinePiece& piece) const { return middle_of(lines_, line_, piece); }
    Vector3d middle(const LinePiece& piece) const { return place(middle_place(piece)); }

    /// The share of rays from here that reach the eye.
    double share_seen(const Vector3d& p, const Vector3d& aside) {
        const double clearance = lengths_.clearance(line_.kind);
        if (!describe(line_.kind).is_on_horizon) return sight_.is_clear(p, clearance, 0);
        double seen = 0;
        int number = 0;
        for (const ContourRay& ray : kContourRays) {
            const Vector3d step =
                std::min(ray.aside * lengths_.mean_edge, kFarthestAside * lengths_.diagonal) *
                aside;
            seen += sight_.is_clear(p + step, ray.towards_eye * clearance, number++);
        }
        return seen / number;
    }
    /// Whether there is more surface on this side of a place: inside a form there is.
    bool is_before_surface(const Vector3d& p, const Vector3d& aside) {
        return sight_.meets_surface(p + kInside * lengths_.diagonal * aside, aside);
    }
    double facing(const Vector3d& p, const Vector3d& aside) const {
        return sight_.facing(p, aside, lengths_.clearance(line_.kind));
    }

private:
    const LineSet& lines_;
    const Polyline& line_;
    const int side_;
    const SightLengths& lengths_;
    Sight& sight_;
};

/// Runs of equal labels, those of a closed line once around.
template <class Visit>
void for_each_run(const std::vector<std::uint8_t>& labels, bool closed, Visit visit) {
    const std::size_t n = labels.size();
    std::size_t first = 0;
    while (closed && first + 1 < n && labels[first] == labels[n - 1])
        ++first;
    if (closed && first + 1 == n) first = 0;
    for (std::size_t k = 0; k < n;) {
        std::vector<std::size_t> run;
        const std::uint8_t label = labels[(first + k) % n];
        for (; k < n && labels[(first + k) % n] == label; ++k)
            run.push_back((first + k) % n);
        visit(label, run);
    }
}

/// Decides about one line.
class Decision {
public:
    Decision(const LineSet& lines, const Polyline& line, int side,
             const PictureCrossings& crossings, const SightLengths& lengths, Sight& sight)
        : line_(line),
          lengths_(lengths),
          is_contour_(describe(line.kind).is_on_horizon),
          voting_(lines, line, side, lengths, sight),
          knows_crossings_(crossings.are_known()),
          crossings_(knows_crossings_ ? crossings.along(line) : std::vector<Passage>()) {
        std::vector<LinePlace> places;
        for (const Passage& crossing : crossings_)
            places.push_back(crossing.place);
        pieces_ = pieces_of(lines, line, kSpacing * lengths.diagonal, places);
        for (const LinePiece& piece : pieces_) {
            middles_.push_back(voting_.middle(piece));
            across_.push_back(voting_.across(piece, middles_.back()));
            asides_.push_back(across_.back().stableNormalized());
        }
        if (is_contour_ && side != 0) find_cusps();
        vote();
    }

    LineDecision result() {
        const auto begin_of = [&](std::size_t i) { return change_before(i); };
        return {parts_of(line_, pieces_, labels_, 1, begin_of),
                parts_of(line_, pieces_, labels_, 0, begin_of)};
    }

private:
    /// Beyond cusps a contour is behind its own surface: the surface there faces to the other side.
    void find_cusps() {
        const double cusp_cost =
            std::max(kCuspCost * lengths_.diagonal, kCuspEdges * lengths_.mean_edge);
        std::vector<LabelCosts> costs(pieces_.size());
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const double facing = voting_.facing(middles_[i], asides_[i]) * pieces_[i].length;
            costs[i].label = {std::max(0., facing), std::max(0., -facing)};
            costs[i].change = {cusp_cost, cusp_cost};
        }
        bends_in_ = cheapest_labels(costs, line_.closed);
        for (std::uint8_t& label : bends_in_)
            label = !label;
        forget_false_folds();
        forget_open_forms();
    }

    bool bends_in(std::size_t i) const { return !bends_in_.empty() && bends_in_[i]; }

    void vote() {
        std::vector<LabelCosts> costs(pieces_.size());
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            set_change(i, costs[i]);
            const double seen = bends_in(i) ? 0 : voting_.share_seen(middles_[i], asides_[i]);
            costs[i].label = {seen * pieces_[i].length, (1 - seen) * pieces_[i].length};
        }
        labels_ = cheapest_labels(costs, line_.closed);
    }

    void set_change(std::size_t i, LabelCosts& costs) const {
        const double at_crossing = kCrossingCost * lengths_.diagonal;
        const double elsewhere =
            (is_contour_ && knows_crossings_ ? kContourCost : kLineCost) * lengths_.diagonal;
        costs.change = {elsewhere, elsewhere};
        const std::size_t before = i > 0 ? i - 1 : pieces_.size() - 1;
        if (bends_in(i) != bends_in(before)) costs.change = {at_crossing, at_crossing};
        if (pieces_[i].place < 0) return;
        const Passage& crossing = crossings_[std::size_t(pieces_[i].place)];
        if (crossing.may_show) costs.change[0] = at_crossing;
        if (crossing.may_hide) costs.change[1] = at_crossing;
    }

    /// Between two cusps a contour runs back in the picture. If it does not, triangles only lean.
    void forget_false_folds() {
        const std::size_t n = pieces_.size();
        for_each_run(bends_in_, line_.closed, [&](bool bends_in, const auto& run) {
            if (!bends_in) return;
            Vector3d way = Vector3d::Zero(), around = Vector3d::Zero();
            double length = 0;
            for (const std::size_t i : run) {
                way += across_[i];
                length += pieces_[i].length;
            }
            if (length > kLongestFalseFold * lengths_.diagonal) return;
            for (std::size_t k = 1; k <= kPiecesAround; ++k) {
                if (line_.closed || run.front() >= k)
                    around += across_[(run.front() + n * k - k) % n];
                if (line_.closed || run.back() + k < n) around += across_[(run.back() + k) % n];
            }
            if (way.dot(around) <= 0) return;
            for (const std::size_t i : run)
                bends_in_[i] = 0;
        });
    }

    /// Beyond cusps contours are hidden by their own form, if that is closed. Where triangles face
    /// inwards, or a surface is open, there is no form beside most of them.
    void forget_open_forms() {
        for_each_run(bends_in_, line_.closed, [&](bool bends_in, const auto& run) {
            if (!bends_in) return;
            double length = 0, inside = 0;
            for (const std::size_t i : run) {
                length += pieces_[i].length;
                inside += pieces_[i].length * voting_.is_before_surface(middles_[i], asides_[i]);
            }
            if (inside > length / 2) return;
            for (const std::size_t i : run)
                bends_in_[i] = 0;
        });
    }

    /// Where exactly sight changes between two pieces: where they meet if an outline or a cusp is
    /// there, else where the votes do.
    LinePlace change_before(std::size_t i) {
        if (i == 0 || pieces_[i].place >= 0 || bends_in(i) != bends_in(i - 1))
            return pieces_[i].begin;
        const auto number = [](const LinePlace& place) { return place.segment + place.t; };
        const auto place = [](double number) {
            const double segment = std::floor(number);
            return LinePlace{std::uint32_t(segment), number - segment};
        };
        const auto is_seen = [&](double at) {
            return voting_.share_seen(voting_.place(place(at)), asides_[i]) > 0.5;
        };
        double low = number(voting_.middle_place(pieces_[i - 1]));
        double high = number(voting_.middle_place(pieces_[i]));
        if (is_seen(low) != bool(labels_[i - 1]) || is_seen(high) != bool(labels_[i]))
            return pieces_[i].begin;
        for (int k = 0; k < kBisections; ++k) {
            const double middle = (low + high) / 2;
            (is_seen(middle) == bool(labels_[i - 1]) ? low : high) = middle;
        }
        return place((low + high) / 2);
    }

    const Polyline& line_;
    const SightLengths& lengths_;
    const bool is_contour_;
    Voting voting_;
    const bool knows_crossings_;
    const std::vector<Passage> crossings_;
    std::vector<LinePiece> pieces_;
    std::vector<Vector3d> middles_, across_, asides_;  // of the pieces; asides are unit or zero
    std::vector<std::uint8_t> bends_in_;               // empty where that is not known
    std::vector<std::uint8_t> labels_;
};

}  // namespace

int free_side(const LineSet& lines, const Polyline& line, const SightLengths& lengths,
              Sight& sight) {
    if (!describe(line.kind).is_on_horizon) return 0;
    const std::vector<LinePiece> pieces = pieces_of(lines, line, kSpacing * lengths.diagonal, {});
    Voting voting(lines, line, 1, lengths, sight);
    int votes = 0, all = 0;
    const std::size_t step = pieces.size() / kSideVotes + 1;
    for (std::size_t i = 0; i < pieces.size(); i += step, ++all) {
        const Vector3d p = voting.middle(pieces[i]);
        const Vector3d aside =
            kSideAside * lengths.diagonal * voting.across(pieces[i], p).stableNormalized();
        const double reach = kSideReach * lengths.diagonal;
        votes += sight.is_near_surface(p - aside, reach) - sight.is_near_surface(p + aside, reach);
    }
    return 3 * votes < -all ? -1 : 1;
}

LineDecision decide(const LineSet& lines, const Polyline& line, int free_side,
                    const PictureCrossings& crossings, const SightLengths& lengths, Sight& sight) {
    return Decision(lines, line, free_side, crossings, lengths, sight).result();
}

}  // namespace laplacian_lines
