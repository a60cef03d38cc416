// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/contour_folds.h"

#include <algorithm>

#include "visibility/chain_labels.h"

namespace laplacian_lines {
namespace {

using Eigen::Vector3d;
using Labels = std::vector<std::uint8_t>;

// What it costs to call a contour bent the other way, in lengths of surfaces that do not face so:
// in D, in mean edges, and the share of it for a possible fold.
constexpr double kCuspCost = 0.002, kCuspEdges = 2, kPossibleShare = 0.4;
// A fold that is no longer than this, in D, has to run back between so many pieces at either end.
constexpr double kLongestFalseFold = 0.05;
constexpr std::size_t kPiecesAround = 3;

class FoldFinding {
public:
    FoldFinding(const std::vector<PlacedPiece>& pieces, bool closed, const SightLengths& lengths,
                LineVotes& votes)
        : pieces_(pieces), closed_(closed), lengths_(lengths), votes_(votes) {
        for (const PlacedPiece& piece : pieces)
            facing_.push_back(votes.facing(piece) * piece.length());
    }

    ContourFolds find() {
        const double cost =
            std::max(kCuspCost * lengths_.diagonal, kCuspEdges * lengths_.mean_edge);
        ContourFolds folds{labels(cost), {}};
        forget_folds(folds.bends_in, [this](const auto& run) { return leans_only(run); });
        forget_folds(folds.bends_in, [this](const auto& run) { return is_open(run); });
        for_each_run(labels(kPossibleShare * cost), closed_, [&](bool bends, const auto& run) {
            const auto is_known = [&](std::size_t i) { return folds.bends_in[i] != 0; };
            if (bends && std::none_of(run.begin(), run.end(), is_known))
                folds.possible.push_back(run);
        });
        return folds;
    }

private:
    using Run = std::vector<std::size_t>;

    Labels labels(double cost) const {
        std::vector<LabelCosts<2>> costs(facing_.size());
        for (std::size_t i = 0; i < facing_.size(); ++i) {
            costs[i].label = {std::max(0., -facing_[i]), std::max(0., facing_[i])};
            costs[i].change = {{{0, cost}, {cost, 0}}};
        }
        return cheapest_labels(costs, closed_);
    }

    template <class IsFalse>
    void forget_folds(Labels& bends_in, IsFalse is_false) {
        const Labels before = bends_in;
        for_each_run(before, closed_, [&](bool bends, const auto& run) {
            if (!bends || !is_false(run)) return;
            for (const std::size_t i : run)
                bends_in[i] = 0;
        });
    }

    double length_of(const Run& run) const {
        double length = 0;
        for (const std::size_t i : run)
            length += pieces_[i].length();
        return length;
    }

    /// Between two cusps a contour runs back in the picture. If it does not, triangles only lean.
    bool leans_only(const Run& run) const {
        if (length_of(run) > kLongestFalseFold * lengths_.diagonal) return false;
        Vector3d way = Vector3d::Zero(), around = Vector3d::Zero();
        for (const std::size_t i : run)
            way += pieces_[i].across;
        const std::size_t n = pieces_.size();
        for (std::size_t k = 1; k <= kPiecesAround; ++k) {
            if (closed_ || run.front() >= k)
                around += pieces_[(run.front() + n * k - k) % n].across;
            if (closed_ || run.back() + k < n) around += pieces_[(run.back() + k) % n].across;
        }
        return way.dot(around) > 0;
    }

    /// Beyond cusps contours are hidden by their own form, if that is closed. Where triangles face
    /// inwards, or a surface is open, there is no form beside most of them.
    bool is_open(const Run& run) {
        double inside = 0;
        for (const std::size_t i : run)
            inside += pieces_[i].length() * votes_.is_before_surface(pieces_[i]);
        return inside <= length_of(run) / 2;
    }

    const std::vector<PlacedPiece>& pieces_;
    const bool closed_;
    const SightLengths& lengths_;
    LineVotes& votes_;
    std::vector<double> facing_;  // times length
};

}  // namespace

ContourFolds find_folds(const std::vector<PlacedPiece>& pieces, bool closed,
                        const SightLengths& lengths, LineVotes& votes) {
    return FoldFinding(pieces, closed, lengths, votes).find();
}

}  // namespace laplacian_lines
