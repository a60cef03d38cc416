// SPDX-License-Identifier: GPL-3.0-or-later
#include "pixels/canvas.h"

#include <algorithm>

namespace line_drawing {
namespace {

using Point = Path::Point;

constexpr double roundness = 0.03;  // pixels of a round tip that its polygon may leave out

/// To the left of a direction where y is down.
Point leftOf(const Point& direction) {
    return {direction.y(), -direction.x()};
}

double cross(const Point& a, const Point& b) {
    return a.x() * b.y() - a.y() * b.x();
}

class Stroke {
public:
    Stroke(double width, bool is_round, std::vector<Polygon>& polygons)
        : radius_(width / 2), is_round_(is_round), polygons_(polygons) {}

    void append(const Polygon& line) {
        Point before = Point::Zero();  // direction of the last piece; 0: there is none
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Point way = line[i] - line[i - 1];
            const double length = way.norm();
            if (!(length > 0)) continue;
            const Point direction = way / length;
            if (before.isZero(0))
                end(line[i - 1], -direction);
            else
                join(line[i - 1], before, direction);
            const Point side = radius_ * leftOf(direction);
            polygons_.push_back(
                {line[i - 1] + side, line[i] + side, line[i] - side, line[i - 1] - side});
            before = direction;
        }
        const bool is_dot = before.isZero(0) && line.size() > 1;
        if (is_dot) end(line[0], {-1, 0});
        if (is_dot || !before.isZero(0)) end(line.back(), is_dot ? Point(1, 0) : before);
    }

private:
    /// All polygons turn the same way, so that they do not cancel.
    void join(const Point& p, const Point& before, const Point& after) {
        const double turn = cross(before, after);
        if (before.dot(after) < 0) {
            halfCircle(p, before);
            halfCircle(p, -after);
        } else if (turn > 0) {
            sector(p, leftOf(before), leftOf(after));
        } else if (turn < 0) {
            sector(p, -leftOf(after), -leftOf(before));
        }
    }

    void end(const Point& p, const Point& outwards) {
        if (is_round_) halfCircle(p, outwards);
    }

    void halfCircle(const Point& p, const Point& middle) {
        sector(p, leftOf(middle), middle);
        sector(p, middle, -leftOf(middle));
    }

    /// For turns of at most a right angle.
    void sector(const Point& p, const Point& from, const Point& to) {
        Polygon polygon = {p, p + radius_ * from};
        arc(p, from, to, polygon);
        polygons_.push_back(std::move(polygon));
    }

    void arc(const Point& p, const Point& from, const Point& to, Polygon& polygon) const {
        const Point sum = from + to;
        const double height = radius_ * (1 - sum.norm() / 2);  // above the chord
        if (height <= roundness) return polygon.push_back(p + radius_ * to);
        const Point middle = sum.normalized();
        arc(p, from, middle, polygon);
        arc(p, middle, to, polygon);
    }

    const double radius_;
    const bool is_round_;
    std::vector<Polygon>& polygons_;
};

/// Begins with a dash.
std::vector<Polygon> dashesOf(const Polygon& line, double dash) {
    std::vector<Polygon> dashes;
    double rest = 0;  // until a dash ends or begins
    bool is_dash = false;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double length = (line[i] - line[i - 1]).norm();
        double done = 0;
        for (; rest < length - done; rest = is_dash ? dash : dash / 2) {
            done += rest;
            const Point place = line[i - 1] + done / length * (line[i] - line[i - 1]);
            if (is_dash)
                dashes.back().push_back(place);
            else
                dashes.push_back({place});
            is_dash = !is_dash;
        }
        rest -= length - done;
        if (is_dash) dashes.back().push_back(line[i]);
    }
    return dashes;
}

}  // namespace

void appendStroke(const Polygon& line, double width, double dash, std::vector<Polygon>& polygons) {
    Stroke stroke(width, dash == 0, polygons);
    const auto is_finite = [](const Point& p) { return p.allFinite(); };
    if (!std::all_of(line.begin(), line.end(), is_finite)) return;
    if (dash == 0) return stroke.append(line);
    for (const Polygon& part : dashesOf(line, dash))
        stroke.append(part);
}

}  // namespace line_drawing
