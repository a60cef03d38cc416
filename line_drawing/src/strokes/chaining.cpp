// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "strokes/drawn_lines.h"
#include "strokes/end_pairs.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

// In pens of inner lines.
constexpr double kLongestGap = 8;  // as long as the shortest ring, which else would be a dot
constexpr double kMeeting = 2;     // ends so near each other meet
constexpr double kSamePlace = 0.5;
constexpr double kTangentReach = 3;  // the direction of an end is taken over this
constexpr double kBendReach = 8;     // 2 √h
constexpr double kSwelling = 4;      // widths pass into each other over this
constexpr double kTurnPrice = 8;     // of a turn of 90°: as the longest gap

constexpr double kBridging = 6;           // gaps: ends that meet move together over this
constexpr double kLongestGapShare = 0.5;  // of the shorter line
constexpr double kGapCosine = 0.866;      // of 30°, to the way over the gap: an arc turns by 60°
constexpr double kMeetingCosine = 0.766;  // of 40°
constexpr double kClearBend = 0.524;      // radians: 30°
constexpr double kCornerCosine = -0.342;  // of 110°; beyond it is another side of the fold

struct End {
    std::size_t line;
    bool is_last;
    Vector2d position, outwards;
    double bend;  // radians to the right on the way out, over kBendReach, if it is an arc
};

double angle_between(const Vector2d& from, const Vector2d& to) {
    return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

/// Whether a way turns to one side, where it turns clearly.
bool turns_one_way(std::initializer_list<double> turns) {
    const auto [least, most] = std::minmax(turns);
    return least > -kClearBend || most < kClearBend;
}

class Chaining {
public:
    Chaining(std::vector<DrawnLine> lines, const Pens& pens, bool mixes_kinds)
        : lines_(std::move(lines)),
          pens_(pens),
          pen_(pens[std::size_t(LineClass::Inner)]),
          mixes_kinds_(mixes_kinds),
          all_(all_of(lines_, pen_)) {
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const bool is_chained =
                is_inner(lines_[i]) || lines_[i].line_class == LineClass::Contour;
            lengths_.push_back(length_of(lines_[i].points));
            if (!is_chained || lines_[i].closed || lines_[i].points.size() < 2) continue;
            for (const bool is_last : {false, true})
                ends_.push_back(end_of(i, is_last));
        }
    }

    std::vector<DrawnLine> run() {
        std::vector<Vector2d> positions;
        for (const End& end : ends_)
            positions.push_back(end.position);
        const auto cost = [this](std::size_t a, std::size_t b) {
            return cost_of(ends_[a], ends_[b]);
        };
        std::vector<DrawnLine> result;
        std::vector<bool> is_done(lines_.size(), false);
        const auto join = [&](const std::vector<std::size_t>& way, bool is_ring) {
            for (const std::size_t e : way)
                is_done[ends_[e].line] = true;
            result.push_back(way.size() == 1 && !is_ring ? std::move(lines_[ends_[way[0]].line])
                                                         : joined(way, is_ring));
        };
        for_each_chain_of_ends(pair_ends(positions, kLongestGap * pen_, cost), join);
        for (std::size_t i = 0; i < lines_.size(); ++i)
            if (!is_done[i]) result.push_back(std::move(lines_[i]));
        return result;
    }

private:
    End end_of(std::size_t i, bool is_last) const {
        const std::vector<DrawnPoint>& points = lines_[i].points;
        // The chord over a reach r of an arc of curvature κ leans by κ r / 2 from its tangent. The
        // difference of two such angles gives κ, and that the turn over kBendReach.
        const Vector2d outwards = outwards_at(points, is_last, kTangentReach * pen_),
                       before = outwards_at(points, is_last, kBendReach * pen_);
        return {i, is_last, (is_last ? points.back() : points.front()).position, outwards,
                2 * kBendReach / (kBendReach - kTangentReach) * angle_between(before, outwards)};
    }

    bool is_contour(const End& end) const {
        return lines_[end.line].line_class == LineClass::Contour;
    }

    /// Whether it is of a contour along sharp edges of the form.
    bool is_edge(const End& end) const {
        return is_contour(end) && !is_curved_contour(lines_[end.line]);
    }

    /// The gap, longer by the turn; nothing if the lines do not continue.
    std::optional<double> cost_of(const End& a, const End& b) const {
        if (a.line == b.line && lengths_[a.line] < kLongestGap * pen_) return {};
        const Vector2d way = b.position - a.position;
        const double gap = way.norm();
        const double straight = -a.outwards.dot(b.outwards);  // cosine of the turn
        const bool meets = gap <= kMeeting * pen_;
        if (!mixes_kinds_ && (is_contour(a) || is_contour(b)) &&
            (is_contour(a) != is_contour(b) || gap > kSamePlace * pen_))
            return {};
        if (meets) {
            const bool is_corner = gap <= kSamePlace * pen_ && !(is_contour(a) && is_contour(b));
            if (straight < (is_corner ? kCornerCosine : kMeetingCosine)) return {};
        } else {
            const double shorter = std::min(lengths_[a.line], lengths_[b.line]);
            if (is_edge(a) || is_edge(b) || gap > kLongestGap * pen_ ||
                gap > kLongestGapShare * shorter || a.outwards.dot(way) < kGapCosine * gap ||
                -b.outwards.dot(way) < kGapCosine * gap || meets_other(a) || meets_other(b))
                return {};
        }
        if (!is_contour(a) && !is_contour(b) &&
            !turns_one_way({a.bend, angle_between(a.outwards, -b.outwards), -b.bend}))
            return {};
        if (gap > kSamePlace * pen_ && is_crossed(a, b)) return {};  // last, as it takes longest
        return gap + (1 - straight) * kTurnPrice * pen_;
    }

    bool meets_other(const End& end) const {
        return all_.is_near(end.position, end.line, kSamePlace * pen_);
    }

    /// Whether another line comes within half a pen of the way, nearer than theirs.
    bool is_crossed(const End& a, const End& b) const {
        constexpr int samples = int(kLongestGap) - 1;  // a pen apart at most
        for (int i = 1; i <= samples; ++i) {
            const double t = double(i) / (samples + 1);
            const auto near = all_.nearest_on((1 - t) * a.position + t * b.position,
                                              DrawnLines::kNoLine, kSamePlace * pen_);
            if (near && near->line != a.line && near->line != b.line) return true;
        }
        return false;
    }

    /// The points of one line of a chain, with weights as shares of the chain's full width.
    struct Piece {
        std::vector<DrawnPoint> points;
        bool is_contour;
    };

    /// A ring begins and ends in the middle of its first line.
    std::vector<Piece> take_pieces(const std::vector<std::size_t>& way, bool is_ring,
                                   LineClass widest) {
        std::vector<Piece> pieces;
        for (const std::size_t e : way) {
            DrawnLine& line = lines_[ends_[e].line];
            std::vector<DrawnPoint> points = std::move(line.points);
            if (ends_[e].is_last) std::reverse(points.begin(), points.end());
            const double share = full_width(line.line_class) / full_width(widest);
            for (DrawnPoint& point : points)
                point.weight *= share;
            pieces.push_back({std::move(points), line.line_class == LineClass::Contour});
        }
        if (is_ring) {
            std::vector<DrawnPoint>& points = pieces.front().points;
            const auto middle = points.begin() + std::ptrdiff_t(points.size() / 2);
            const Piece end{{points.begin(), middle + 1}, pieces.front().is_contour};
            points.erase(points.begin(), middle);
            pieces.push_back(end);
        }
        return pieces;
    }

    /// The lines that are entered by these ends, one after the other.
    DrawnLine joined(const std::vector<std::size_t>& way, bool is_ring) {
        const auto line_of = [this](std::size_t e) -> DrawnLine& { return lines_[ends_[e].line]; };
        const auto is_wider = [&](std::size_t a, std::size_t b) {
            return line_of(a).line_class < line_of(b).line_class;
        };
        const std::size_t widest = *std::min_element(way.begin(), way.end(), is_wider);
        DrawnLine result = with_points(line_of(widest), {}, is_ring);
        for (const std::size_t e : way)
            result.jump = std::max(result.jump, line_of(e).jump);
        std::vector<std::size_t> seams;  // the last points before them
        bool was_contour = false;
        for (Piece& piece : take_pieces(way, is_ring, result.line_class)) {
            if (!result.points.empty()) {
                cut_overlap(result.points, piece.points);
                meet(result.points, was_contour, piece.points, piece.is_contour);
                seams.push_back(result.points.size() - 1);
            }
            was_contour = piece.is_contour;
            result.points.insert(result.points.end(), piece.points.begin(), piece.points.end());
        }
        if (is_ring) result.points.back() = result.points.front();
        std::vector<double> places = {0};  // along the line
        for (std::size_t i = 1; i < result.points.size(); ++i)
            places.push_back(places.back() +
                             (result.points[i].position - result.points[i - 1].position).norm());
        for (const std::size_t seam : seams)
            blend(places, places[seam], result.points);
        return result;
    }

    /// Lines that meet may overshoot each other, or hook back. A sharp corner may lose up to two
    /// pens by this, and moves by one.
    void cut_overlap(const std::vector<DrawnPoint>& before, std::vector<DrawnPoint>& points) const {
        const std::size_t n = before.size();
        if (n < 2) return;
        const Vector2d& end = before[n - 1].position;
        const Vector2d along = end - before[n - 2].position;
        std::size_t first = 0;
        while (first + 2 < points.size() &&
               (points[first].position - end).norm() < kMeeting * pen_ &&
               (points[first].position - end).dot(along) <= 0)
            ++first;
        points.erase(points.begin(), points.begin() + std::ptrdiff_t(first));
    }

    /// Brings both ends to one place between them, without a step; contours stay.
    void meet(std::vector<DrawnPoint>& before, bool is_fixed, std::vector<DrawnPoint>& after,
              bool is_after_fixed) const {
        const Vector2d gap = after.front().position - before.back().position;
        if (gap.norm() > kMeeting * pen_ || (is_fixed && is_after_fixed)) return;
        const double share = is_fixed ? 0 : is_after_fixed ? 1 : 0.5;
        shift_end(before, true, share * gap, kBridging * gap.norm());
        shift_end(after, false, (share - 1) * gap, kBridging * gap.norm());
        before.back().position = after.front().position;
        if (after.size() > 2) after.erase(after.begin());
    }

    /// Faint lines taper from the width of clear ones.
    double full_width(LineClass c) const {
        return pens_[std::size_t(c == LineClass::Fine ? LineClass::Inner : c)];
    }

    /// Leads from the mean width before the seam to that after it. `places`: of the points, along
    /// the line.
    void blend(const std::vector<double>& places, double seam,
               std::vector<DrawnPoint>& points) const {
        const double reach = kSwelling * pen_;
        double sums[2] = {0, 0};
        int counts[2] = {0, 0};
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double distance = std::abs(places[i] - seam);
            if (distance < reach / 2 || distance > reach) continue;
            const int side = places[i] > seam;
            sums[side] += points[i].weight;
            ++counts[side];
        }
        if (counts[0] == 0 || counts[1] == 0) return;
        const double before = sums[0] / counts[0], after = sums[1] / counts[1];
        for (std::size_t i = 0; i < points.size(); ++i)
            if (std::abs(places[i] - seam) < reach / 2)
                points[i].weight = before + (after - before) * ((places[i] - seam) / reach + 0.5);
    }

    std::vector<DrawnLine> lines_;
    const Pens& pens_;
    const double pen_;
    const bool mixes_kinds_;
    DrawnLines all_;
    std::vector<double> lengths_;
    std::vector<End> ends_;
};

}  // namespace

std::vector<DrawnLine> chain(std::vector<DrawnLine> lines, const Pens& pens, bool mixes_kinds) {
    return Chaining(std::move(lines), pens, mixes_kinds).run();
}

}  // namespace line_drawing
