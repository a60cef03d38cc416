// SPDX-License-Identifier: GPL-3.0-or-later
// Where lines that doubled others went, those that met them end in nothing:
//  1. A short line that was left out comes back if it leads from such a loose end to another line.
//  2. An edge that has passed another ends there.
//  3. From the other loose ends a straight piece leads to the nearest line, if it is beside them.
#include <optional>

#include "strokes/drawn_lines.h"
#include "strokes/strokes.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

/// Whether a line may not move: an edge of the form, or a contour, which has been smoothed.
bool is_edge(const DrawnLine& line) {
    return line.line_class < LineClass::Inner && is_fixed(line);
}

class EdgeJoining {
public:
    EdgeJoining(std::vector<DrawnLine>& lines, double reach)
        : lines_(lines), reach_(reach), all_(all_of(lines, reach)) {}

    void bring_back(const std::vector<DrawnLine>& left_out) {
        DrawnLines loose(reach_);
        const Vector2d piece(kSameReach * reach_, 0);  // points alone cannot be asked for
        for (std::size_t i = 0; i < lines_.size(); ++i)
            for (const bool is_last : {false, true})
                if (is_loose_end(i, is_last))
                    loose.add({end(i, is_last), end(i, is_last) + piece}, i);
        for (const DrawnLine& line : left_out)
            if (bridges(line, loose)) {
                all_.add(positions_of(line), lines_.size());
                lines_.push_back(line);
            }
    }

    void cut_back() {
        for_each_loose_end([&](std::size_t i, bool is_last, const Vector2d& to) {
            if (is_long_edge(i) && runs_back(i, is_last, to)) shorten(i, is_last, to);
        });
        all_ = all_of(lines_, reach_);  // without what was cut off
    }

    void lead() {
        for_each_loose_end([&](std::size_t i, bool is_last, const Vector2d& to) {
            if (is_long_edge(i) || !runs_back(i, is_last, to)) extend(i, is_last, to);
        });
    }

private:
    bool is_loose(std::size_t line, const Vector2d& end) const {
        return !all_.is_near(end, line, kSameReach * reach_);
    }

    Vector2d end(std::size_t i, bool is_last) const {
        return (is_last ? lines_[i].points.back() : lines_[i].points.front()).position;
    }

    /// Outlines are closed; sections may end where the surface does.
    bool is_loose_end(std::size_t i, bool is_last) const {
        return !lines_[i].closed && lines_[i].line_class != LineClass::Section &&
               is_loose(i, end(i, is_last));
    }

    /// visit(line, is_last, place on the line beside that end)
    template <class Visit>
    void for_each_loose_end(Visit visit) {
        for (std::size_t i = 0; i < lines_.size(); ++i)
            for (const bool is_last : {false, true}) {
                if (!is_loose_end(i, is_last)) continue;
                const Vector2d from = end(i, is_last);
                const auto place = all_.nearest_on(from, i, kBesideReach * reach_);
                if (place)
                    visit(i, is_last, loose_end_near(place->line, from).value_or(place->position));
            }
    }

    /// Whether a line leads from a loose end to another line.
    bool bridges(const DrawnLine& line, const DrawnLines& loose) const {
        const Vector2d ends[2] = {line.points.front().position, line.points.back().position};
        for (int k = 0; k < 2; ++k) {
            const auto from =
                loose.nearest_on(ends[k], DrawnLines::kNoLine, 2 * kSameReach * reach_);
            if (from && is_loose(from->line, from->position) &&
                all_.is_near(ends[1 - k], from->line, kBesideReach * reach_))
                return true;
        }
        return false;
    }

    /// A shorter edge would vanish in the piece that joins it.
    bool is_long_edge(std::size_t i) const {
        return is_edge(lines_[i]) && length_of(lines_[i].points) > 2 * kBesideReach * reach_;
    }

    /// A loose end of this line near `from`, that of another: one piece then joins both.
    std::optional<Vector2d> loose_end_near(std::size_t i, const Vector2d& from) const {
        for (const bool is_last : {false, true})
            if (is_loose_end(i, is_last) && (end(i, is_last) - from).norm() < kBesideReach * reach_)
                return end(i, is_last);
        return {};
    }

    /// From the point before an end to it.
    Vector2d last_way(std::size_t i, bool is_last) const {
        const std::vector<DrawnPoint>& points = lines_[i].points;
        return end(i, is_last) - (is_last ? points[points.size() - 2] : points[1]).position;
    }

    /// Whether the line would double back to get there.
    bool runs_back(std::size_t i, bool is_last, const Vector2d& to) const {
        return (to - end(i, is_last)).normalized().dot(last_way(i, is_last).normalized()) <
               kReversal;
    }

    /// Cuts the line back to a line that it has passed, if that leaves no white.
    void shorten(std::size_t i, bool is_last, const Vector2d& to) {
        std::vector<DrawnPoint>& points = lines_[i].points;
        const Vector2d way = last_way(i, is_last), past = end(i, is_last) - to;
        const double share = past.dot(way) / way.squaredNorm();
        if (share > 0 && share < 1 && (past - share * way).norm() <= kSameReach * reach_)
            (is_last ? points.back() : points.front()).position = to;
    }

    void extend(std::size_t i, bool is_last, const Vector2d& to) {
        std::vector<DrawnPoint>& points = lines_[i].points;
        all_.add({end(i, is_last), to}, i);
        DrawnPoint point = is_last ? points.back() : points.front();
        point.position = to;
        point.node = laplacian_lines::kNoNode;
        point.is_exact = true;
        point.is_smoothed = false;
        points.insert(is_last ? points.end() : points.begin(), point);
    }

    std::vector<DrawnLine>& lines_;
    const double reach_;
    DrawnLines all_;
};

}  // namespace

void join_edges(std::vector<DrawnLine>& lines, const std::vector<DrawnLine>& left_out,
                double reach) {
    EdgeJoining joining(lines, reach);
    joining.bring_back(left_out);
    joining.cut_back();
    joining.lead();
}

}  // namespace line_drawing
