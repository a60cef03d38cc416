// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/line_decision.h"

#include <algorithm>
#include <cmath>

#include "visibility/contour_folds.h"
#include "visibility/layers.h"

namespace laplacian_lines {
namespace {

// What it costs, in D of wrong votes, to come into sight or go out of it; and a layer by which the
// number of layers before a contour changes otherwise than outlines and cusps say: where an outline
// passes, elsewhere, and elsewhere on other lines.
constexpr double kSightCost = 0.001;
constexpr double kPassageCost = 0.04, kContourCost = 0.02, kLineCost = 0.0005;
// Outlines that are nearer to a line than this may lie beside their place; in D, in mean edges.
constexpr double kSure = 0.002, kSureEdges = 3;
// A knot of a line with itself that is shorter is too small to be shown; in D, in mean edges.
constexpr double kSmallestKnot = 0.008, kSmallestKnotEdges = 5;
constexpr int kSideVotes = 32;  // on a line
constexpr int kBisections = 8;

/// Decides about one line.
class Decision {
public:
    Decision(const LineSet& lines, const Polyline& line, int side,
             const PictureCrossings& crossings, const SightLengths& lengths, Sight& sight)
        : line_(line),
          lengths_(lengths),
          is_contour_(describe(line.kind).is_on_horizon),
          votes_(lines, line, side, lengths, sight),
          knows_crossings_(crossings.are_known()) {
        const std::vector<Passage> passages =
            knows_crossings_ ? crossings.along(line) : std::vector<Passage>();
        std::vector<LinePlace> places;
        for (const Passage& passage : passages)
            places.push_back(passage.place);
        pieces_ = votes_.pieces(places);
        if (is_contour_ && side != 0) folds_ = find_folds(pieces_, line.closed, lengths, votes_);
        find_steps(steps_of(lines, line, passages,
                            std::max(kSure * lengths.diagonal, kSureEdges * lengths.mean_edge)));
        vote();
        hide_folds();
        show_knots();
    }

    LineDecision result() {
        std::vector<LinePiece> pieces;
        for (const PlacedPiece& piece : pieces_)
            pieces.push_back(piece.piece);
        const auto begin_of = [&](std::size_t i) { return change_before(i); };
        return {parts_of(line_, pieces, is_seen_, 1, begin_of),
                parts_of(line_, pieces, is_seen_, 0, begin_of)};
    }

private:
    bool bends_in(std::size_t i) const { return !folds_.bends_in.empty() && folds_.bends_in[i]; }

    void vote() {
        const LayerPrices elsewhere =
                              prices(is_contour_ && knows_crossings_ ? kContourCost : kLineCost),
                          at_passage = prices(is_contour_ ? kPassageCost : kLineCost);
        std::vector<LayerCosts> costs;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            shares_seen_.push_back(
                bends_in(i) ? 0 : votes_.share_seen(pieces_[i].middle, pieces_[i].aside));
            costs.push_back(layer_costs(pieces_[i].length(), shares_seen_[i], steps_[i],
                                        pieces_[i].piece.place < 0 ? elsewhere : at_passage));
        }
        is_seen_ = cheapest_labels(costs, line_.closed);
        for (std::uint8_t& label : is_seen_)
            label = label == 0;
    }

    LayerPrices prices(double layer) const {
        return {layer * lengths_.diagonal, kSightCost * lengths_.diagonal};
    }

    void find_steps(const std::vector<LayerStep>& at_passages) {
        steps_.resize(pieces_.size());
        int next = 0;  // of several crossings at the same place a piece names the last one
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            for (; next <= pieces_[i].piece.place; ++next)
                steps_[i] += at_passages[std::size_t(next)];
            const std::size_t before = i > 0 ? i - 1 : pieces_.size() - 1;
            // beyond a cusp there is the near part of the form before a contour; before one whose
            // near part is the fold, there was another layer
            if (bends_in(i) && !bends_in(before)) steps_[i] += {0, 1};
            if (!bends_in(i) && bends_in(before)) steps_[i] += {-1, 0};
        }
        for (const auto& fold : folds_.possible)
            steps_[fold[fold.size() / 2]] += {-1, 1};
    }

    /// A line that goes out of sight in a possible fold does so at its nearer cusp.
    void hide_folds() {
        is_in_possible_fold_.resize(pieces_.size());
        for (const auto& fold : folds_.possible)
            if (!is_seen_[fold.front()] || !is_seen_[fold.back()])
                for (const std::size_t i : fold) {
                    is_seen_[i] = 0;
                    is_in_possible_fold_[i] = 1;
                }
    }

    /// A contour that is back at once is not cut, unless outlines or cusps at both ends say so.
    void show_knots() {
        if (!is_contour_) return;
        const double smallest =
            std::min(kSmallestKnot * lengths_.diagonal, kSmallestKnotEdges * lengths_.mean_edge);
        const std::vector<std::uint8_t> before = is_seen_;
        for_each_run(before, line_.closed, [&](bool is_seen, const auto& run) {
            if (is_seen) return;
            double length = 0;
            bool has_fold = false;
            for (const std::size_t i : run) {
                length += pieces_[i].length();
                has_fold |= is_in_possible_fold_[i] != 0;
            }
            if (length > smallest || !(has_fold || is_slip(run, length))) return;
            for (const std::size_t i : run)
                is_seen_[i] = 1;
        });
    }

    /// Whether pieces that rays see are hidden because an outline seems to be passed that is not
    /// passed back.
    bool is_slip(const std::vector<std::size_t>& run, double length) const {
        const std::size_t n = pieces_.size(), after = (run.back() + 1) % n;
        const bool is_at_end = !line_.closed && (run.front() == 0 || after == 0);
        if (is_at_end || run.size() == n) return false;
        if (!steps_[run.front()].may_be_none() && !steps_[after].may_be_none()) return false;
        double seen = 0;
        for (const std::size_t i : run) {
            if (bends_in(i)) return false;
            seen += shares_seen_[i] * pieces_[i].length();
        }
        return 2 * seen > length;
    }

    /// Where exactly sight changes between two pieces: where they meet if an outline or a cusp is
    /// there, else where the votes do.
    LinePlace change_before(std::size_t i) {
        const LinePiece& piece = pieces_[i].piece;
        if (i == 0 || piece.place >= 0 || bends_in(i) != bends_in(i - 1)) return piece.begin;
        const auto number = [](const LinePlace& place) { return place.segment + place.t; };
        const auto place = [](double number) {
            const double segment = std::floor(number);
            return LinePlace{std::uint32_t(segment), number - segment};
        };
        const auto is_seen = [&](double at) {
            return votes_.share_seen(votes_.place(place(at)), pieces_[i].aside) > 0.5;
        };
        double low = number(votes_.middle_place(pieces_[i - 1].piece));
        double high = number(votes_.middle_place(piece));
        if (is_seen(low) != bool(is_seen_[i - 1]) || is_seen(high) != bool(is_seen_[i]))
            return piece.begin;
        for (int k = 0; k < kBisections; ++k) {
            const double middle = (low + high) / 2;
            (is_seen(middle) == bool(is_seen_[i - 1]) ? low : high) = middle;
        }
        return place((low + high) / 2);
    }

    const Polyline& line_;
    const SightLengths& lengths_;
    const bool is_contour_;
    LineVotes votes_;
    const bool knows_crossings_;
    std::vector<PlacedPiece> pieces_;
    ContourFolds folds_;
    // By piece; steps are before it.
    std::vector<LayerStep> steps_;
    std::vector<double> shares_seen_;
    std::vector<std::uint8_t> is_in_possible_fold_, is_seen_;
};

}  // namespace

int free_side(const LineSet& lines, const Polyline& line, const SightLengths& lengths,
              Sight& sight) {
    if (!describe(line.kind).is_on_horizon) return 0;
    LineVotes line_votes(lines, line, 1, lengths, sight);
    const std::vector<PlacedPiece> pieces = line_votes.pieces({});
    int votes = 0, all = 0;
    const std::size_t step = pieces.size() / kSideVotes + 1;
    for (std::size_t i = 0; i < pieces.size(); i += step, ++all)
        votes += line_votes.surface_across(pieces[i]);
    return 3 * votes < -all ? -1 : 1;
}

LineDecision decide(const LineSet& lines, const Polyline& line, int free_side,
                    const PictureCrossings& crossings, const SightLengths& lengths, Sight& sight) {
    return Decision(lines, line, free_side, crossings, lengths, sight).result();
}

}  // namespace laplacian_lines
