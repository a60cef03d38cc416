// SPDX-License-Identifier: GPL-3.0-or-later
// Gray pictures of polygons and strokes:
//  1. Each row of pixels has 16 lines; polygons' sides that cross a line divide it into spans
//     inside and outside, in steps of a 256th of a pixel.
//  2. Spans add up to the coverage of each pixel of the row, which is then painted.
//  3. A stroke is a polygon for each piece, sectors where they meet, and half circles at its ends.
#include "pixels/canvas.h"

#include <algorithm>
#include <cmath>

namespace line_drawing {
namespace {

using Point = Path::Point;

constexpr double kFarthest = 1e9;  // coordinates are clamped to it
constexpr int kLinesOfPixel = 16, kStepsOfPixel = 256, kWhole = kLinesOfPixel * kStepsOfPixel;

struct Side {
    int first, end;
    double x, slope;  ///< at `first`, and from line to line; in steps
    int winding;
};

struct Crossing {
    int x;  ///< in steps
    int winding;
};

/// The first line not above y, within the picture.
int line_from(double y, int line_count) {
    return int(std::clamp(std::ceil(y * kLinesOfPixel - 0.5), 0., double(line_count)));
}

bool is_finite(const Polygon& polygon) {
    return std::all_of(polygon.begin(), polygon.end(),
                       [](const Point& p) { return p.allFinite(); });
}

Point within(const Point& p) {
    return p.cwiseMax(-kFarthest).cwiseMin(kFarthest);
}

std::vector<Side> sides_of(const std::vector<Polygon>& polygons, int line_count) {
    std::vector<Side> sides;
    for (const Polygon& polygon : polygons) {
        if (!is_finite(polygon)) continue;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            Point p = within(polygon[i]), q = within(polygon[(i + 1) % polygon.size()]);
            const int winding = p.y() < q.y() ? 1 : -1;
            if (winding < 0) std::swap(p, q);
            const int first = line_from(p.y(), line_count), end = line_from(q.y(), line_count);
            if (first == end) continue;
            const double slope = (q.x() - p.x()) / (q.y() - p.y());
            const double y = (first + 0.5) / kLinesOfPixel;
            sides.push_back({first, end, (p.x() + (y - p.y()) * slope) * kStepsOfPixel,
                             slope * kStepsOfPixel / kLinesOfPixel, winding});
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.first < b.first; });
    return sides;
}

/// The coverage of the pixels in a row.
class Coverage {
public:
    explicit Coverage(int width)
        : limit_(width * kStepsOfPixel), parts_(std::size_t(width) + 1), starts_(parts_.size()) {}

    int limit() const { return limit_; }

    void add(int begin, int end) {
        if (begin >= end) return;
        const int first = begin / kStepsOfPixel, last = end / kStepsOfPixel;
        from_ = std::min(from_, first);
        to_ = std::max(to_, last);
        // Whole pixels, less the part before the start, plus the part in the last.
        starts_[std::size_t(first)] += kStepsOfPixel;
        starts_[std::size_t(last)] -= kStepsOfPixel;
        parts_[std::size_t(first)] -= begin % kStepsOfPixel;
        parts_[std::size_t(last)] += end % kStepsOfPixel;
    }

    /// Paints the row and starts over.
    void paint(std::uint8_t* row, int gray) {
        int covered = 0;
        for (int x = from_; x <= to_; ++x) {
            covered += std::exchange(starts_[std::size_t(x)], 0);
            const int share = covered + std::exchange(parts_[std::size_t(x)], 0);
            if (share > 0)
                row[x] =
                    std::uint8_t((gray * share + row[x] * (kWhole - share) + kWhole / 2) / kWhole);
        }
        from_ = limit_;
        to_ = -1;
    }

private:
    int limit_, from_ = limit_, to_ = -1;
    std::vector<int> parts_, starts_;  ///< and one for spans that end at the right border
};

void cover(std::vector<Crossing>& crossings, FillRule rule, Coverage& coverage) {
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].winding;
        if (rule == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0)
            coverage.add(crossings[i].x, crossings[i + 1].x);
    }
}

constexpr double kRoundness = 0.03;  // pixels between a round tip and its polygon

/// The direction to the left, with y down.
Point left_of(const Point& direction) {
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
            const Point span = line[i] - line[i - 1];
            const double length = span.norm();
            if (!(length > 0)) continue;
            const Point direction = span / length;
            if (before.isZero(0))
                end(line[i - 1], -direction);
            else
                join(line[i - 1], before, direction);
            const Point side = radius_ * left_of(direction);
            polygons_.push_back(
                {line[i - 1] + side, line[i] + side, line[i] - side, line[i - 1] - side});
            before = direction;
        }
        const bool is_dot = before.isZero(0) && line.size() > 1;
        if (is_dot) end(line[0], {-1, 0});
        if (is_dot || !before.isZero(0)) end(line.back(), is_dot ? Point(1, 0) : before);
    }

private:
    /// All polygons have the same orientation, so that they do not cancel.
    void join(const Point& p, const Point& before, const Point& after) {
        const double turn = cross(before, after);
        if (before.dot(after) < 0) {
            half_circle(p, before);
            half_circle(p, -after);
        } else if (turn > 0) {
            sector(p, left_of(before), left_of(after));
        } else if (turn < 0) {
            sector(p, -left_of(after), -left_of(before));
        }
    }

    void end(const Point& p, const Point& outwards) {
        if (is_round_) half_circle(p, outwards);
    }

    void half_circle(const Point& p, const Point& middle) {
        sector(p, left_of(middle), middle);
        sector(p, middle, -left_of(middle));
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
        if (height <= kRoundness) return polygon.push_back(p + radius_ * to);
        const Point middle = sum.normalized();
        arc(p, from, middle, polygon);
        arc(p, middle, to, polygon);
    }

    const double radius_;
    const bool is_round_;
    std::vector<Polygon>& polygons_;
};

/// Begins with a dash.
std::vector<Polygon> dashes_of(const Polygon& line, double dash) {
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

Canvas::Canvas(int width, int height)
    : width_(width), height_(height), grays_(std::size_t(width) * std::size_t(height), 255) {}

void Canvas::fill(const std::vector<Polygon>& polygons, FillRule rule, double tone) {
    const int gray = int(std::lround(255 * tone)), line_count = height_ * kLinesOfPixel;
    const std::vector<Side> sides = sides_of(polygons, line_count);
    Coverage coverage(width_);
    std::vector<Side> crossed;
    std::vector<Crossing> crossings;
    auto next = sides.begin();
    for (int line = sides.empty() ? line_count : next->first; line < line_count; ++line) {
        crossed.erase(std::remove_if(crossed.begin(), crossed.end(),
                                     [&](const Side& side) { return side.end == line; }),
                      crossed.end());
        while (next != sides.end() && next->first == line)
            crossed.push_back(*next++);
        crossings.clear();
        for (const Side& side : crossed) {
            const double x = side.x + (line - side.first) * side.slope;
            crossings.push_back(
                {int(std::clamp(x + 0.5, 0., double(coverage.limit()))), side.winding});
        }
        cover(crossings, rule, coverage);
        const bool is_last = crossed.empty() && next == sides.end();
        if (is_last || line % kLinesOfPixel == kLinesOfPixel - 1)
            coverage.paint(grays_.data() + std::size_t(line / kLinesOfPixel) * std::size_t(width_),
                           gray);
        if (is_last) break;
    }
}

void append_stroke(const Polygon& line, double width, double dash, std::vector<Polygon>& polygons) {
    Stroke stroke(width, dash == 0, polygons);
    if (!is_finite(line)) return;
    if (dash == 0) return stroke.append(line);
    for (const Polygon& part : dashes_of(line, dash))
        stroke.append(part);
}

}  // namespace line_drawing
