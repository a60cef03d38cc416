// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

#include <array>

#include "strokes/drawn_lines.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

/// Whether a line may not move: an edge of the form, or a contour, which has been eased.
bool isEdge(const DrawnLine& line) {
    return line.line_class < LineClass::Inner && isFixed(line);
}

class EndJoining {
public:
    EndJoining(std::vector<DrawnLine>& lines, double reach)
        : lines_(lines), reach_(reach), all_(allOf(lines, reach)) {}

    void bringBack(const std::vector<DrawnLine>& left_out) {
        DrawnLines loose(reach_);
        for (std::size_t i = 0; i < lines_.size(); ++i)
            for (const Vector2d& end : looseEnds(i))
                loose.add({end, end + Vector2d(same_reach * reach_, 0)}, i);
        for (const DrawnLine& line : left_out)
            if (bridges(line, loose)) {
                all_.add(positionsOf(line), lines_.size());
                lines_.push_back(line);
            }
    }

    void lead() {
        for (std::size_t i = 0; i < lines_.size(); ++i)
            for (const Vector2d& end : looseEnds(i))
                if (const auto place = all_.nearestOn(end, i, beside_reach * reach_)) {
                    const Vector2d to = looseEndNear(*place, end).value_or(place->position);
                    if (!runsBack(i, end, to) ||
                        (isEdge(lines_[i]) && isLong(i) && !shorten(i, end, to)))
                        extend(i, end, to);
                }
    }

private:
    bool isLoose(std::size_t line, const Vector2d& end) const {
        return !all_.isNear(end, line, same_reach * reach_);
    }

    /// Outlines are closed; sections may end where the surface does.
    std::vector<Vector2d> looseEnds(std::size_t i) const {
        const DrawnLine& line = lines_[i];
        std::vector<Vector2d> ends;
        if (line.closed || line.line_class == LineClass::Section) return ends;
        for (const DrawnPoint& end : {line.points.front(), line.points.back()})
            if (isLoose(i, end.position)) ends.push_back(end.position);
        return ends;
    }

    /// Whether a line leads from a loose end to another line.
    bool bridges(const DrawnLine& line, const DrawnLines& loose) const {
        const std::array<Vector2d, 2> ends = {line.points.front().position,
                                              line.points.back().position};
        for (int k = 0; k < 2; ++k) {
            const auto from = loose.nearestOn(ends[k], none, 2 * same_reach * reach_);
            if (from && isLoose(from->line, from->position) &&
                all_.isNear(ends[1 - k], from->line, beside_reach * reach_))
                return true;
        }
        return false;
    }

    /// A shorter line would vanish in the piece that joins it.
    bool isLong(std::size_t i) const {
        return lengthOf(lines_[i].points) > 2 * beside_reach * reach_;
    }

    /// The line's own loose end near a place: one piece then joins both.
    std::optional<Vector2d> looseEndNear(const DrawnLines::Place& place,
                                         const Vector2d& from) const {
        for (const Vector2d& end : looseEnds(place.line))
            if ((end - from).norm() < beside_reach * reach_) return end;
        return {};
    }

    /// Cuts the line back to a line that it has passed, if that leaves no white. Whether it did.
    bool shorten(std::size_t i, const Vector2d& end, const Vector2d& to) {
        std::vector<DrawnPoint>& points = lines_[i].points;
        const bool is_first = points.front().position == end;
        const Vector2d way = end - (is_first ? points[1] : points[points.size() - 2]).position;
        const Vector2d past = end - to;
        const double share = past.dot(way) / way.squaredNorm();
        if (!(share > 0 && share < 1) || (past - share * way).norm() > same_reach * reach_)
            return false;
        (is_first ? points.front() : points.back()).position = to;
        return true;
    }

    /// Whether the line's own stroke is there already.
    bool runsBack(std::size_t i, const Vector2d& end, const Vector2d& to) const {
        const std::vector<DrawnPoint>& points = lines_[i].points;
        const bool is_first = points.front().position == end;
        const Vector2d before = (is_first ? points[1] : points[points.size() - 2]).position;
        return (to - end).normalized().dot((end - before).normalized()) < reversal;
    }

    void extend(std::size_t i, const Vector2d& end, const Vector2d& to) {
        std::vector<DrawnPoint>& points = lines_[i].points;
        const bool is_first = points.front().position == end;
        DrawnPoint point{to, (is_first ? points.front() : points.back()).weight};
        points.insert(is_first ? points.begin() : points.end(), point);
        all_.add({end, to}, i);
    }

    static constexpr std::size_t none = std::size_t(-1);
    std::vector<DrawnLine>& lines_;
    const double reach_;
    DrawnLines all_;
};

}  // namespace

void joinLooseEnds(std::vector<DrawnLine>& lines, const std::vector<DrawnLine>& left_out,
                   double reach) {
    EndJoining joining(lines, reach);
    joining.bringBack(left_out);
    joining.lead();
}

}  // namespace line_drawing
