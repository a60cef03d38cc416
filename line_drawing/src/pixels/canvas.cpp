// SPDX-License-Identifier: GPL-3.0-or-later
#include "pixels/canvas.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace line_drawing {
namespace {

constexpr double farthest = 1e9;  // what is beyond that is drawn as if it were there
constexpr int lines_of_pixel = 16, steps_of_pixel = 256, whole = lines_of_pixel * steps_of_pixel;

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
int lineFrom(double y, int line_count) {
    return int(std::clamp(std::ceil(y * lines_of_pixel - 0.5), 0., double(line_count)));
}

bool isFinite(const Polygon& polygon) {
    return std::all_of(polygon.begin(), polygon.end(),
                       [](const Path::Point& p) { return p.allFinite(); });
}

Path::Point within(const Path::Point& p) {
    return p.cwiseMax(-farthest).cwiseMin(farthest);
}

std::vector<Side> sidesOf(const std::vector<Polygon>& polygons, int line_count) {
    std::vector<Side> sides;
    for (const Polygon& polygon : polygons) {
        if (!isFinite(polygon)) continue;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            Path::Point p = within(polygon[i]), q = within(polygon[(i + 1) % polygon.size()]);
            const int winding = p.y() < q.y() ? 1 : -1;
            if (winding < 0) std::swap(p, q);
            const int first = lineFrom(p.y(), line_count), end = lineFrom(q.y(), line_count);
            if (first == end) continue;
            const double slope = (q.x() - p.x()) / (q.y() - p.y());
            const double y = (first + 0.5) / lines_of_pixel;
            sides.push_back({first, end, (p.x() + (y - p.y()) * slope) * steps_of_pixel,
                             slope * steps_of_pixel / lines_of_pixel, winding});
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.first < b.first; });
    return sides;
}

/// Of the pixels in a row.
class Coverage {
public:
    explicit Coverage(int width)
        : limit_(width * steps_of_pixel), parts_(std::size_t(width) + 1), starts_(parts_.size()) {}

    int limit() const { return limit_; }

    void add(int begin, int end) {
        if (begin >= end) return;
        const int first = begin / steps_of_pixel, last = end / steps_of_pixel;
        from_ = std::min(from_, first);
        to_ = std::max(to_, last);
        // Whole pixels, less what is before the first, and what is in the last.
        starts_[std::size_t(first)] += steps_of_pixel;
        starts_[std::size_t(last)] -= steps_of_pixel;
        parts_[std::size_t(first)] -= begin % steps_of_pixel;
        parts_[std::size_t(last)] += end % steps_of_pixel;
    }

    /// Paints the row and starts over.
    void paint(std::uint8_t* row, int gray) {
        int covered = 0;
        for (int x = from_; x <= to_; ++x) {
            covered += std::exchange(starts_[std::size_t(x)], 0);
            const int share = covered + std::exchange(parts_[std::size_t(x)], 0);
            if (share > 0)
                row[x] =
                    std::uint8_t((gray * share + row[x] * (whole - share) + whole / 2) / whole);
        }
        from_ = limit_;
        to_ = -1;
    }

private:
    int limit_, from_ = limit_, to_ = -1;
    std::vector<int> parts_, starts_;  ///< and one for what ends at the right border
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

}  // namespace

Canvas::Canvas(int width, int height)
    : width_(width), height_(height), grays_(std::size_t(width) * std::size_t(height), 255) {}

void Canvas::fill(const std::vector<Polygon>& polygons, FillRule rule, double tone) {
    const int gray = int(std::lround(255 * tone)), line_count = height_ * lines_of_pixel;
    const std::vector<Side> sides = sidesOf(polygons, line_count);
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
        if (is_last || line % lines_of_pixel == lines_of_pixel - 1)
            coverage.paint(grays_.data() + std::size_t(line / lines_of_pixel) * std::size_t(width_),
                           gray);
        if (is_last) break;
    }
}

}  // namespace line_drawing
