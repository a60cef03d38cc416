// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/slight_lines.h"

#include <algorithm>
#include <unordered_map>

#include "strokes/refining.h"

namespace line_drawing {
namespace {

// Of the shortest line: ends of contours of curved surfaces, which the roughness of a scan makes.
constexpr double shortest_contour_end = 3;

/// Of the full width: of a pen of .25 mm about the .06 mm of the thinnest stroke that is drawn.
constexpr double least_weight = 0.25;
// in pens of inner lines
constexpr double longest_faint = 28;  // 7 √h: with 16 a groove under noise was two strokes
constexpr double step = 0.5;

bool isCurvedContour(const DrawnLine& line) {
    return line.line_class == LineClass::Contour && isSmooth(line);
}

bool isSlight(const DrawnLine& line, const SheetOptions& options) {
    return isCurvedContour(line) && line.jump < options.pens[std::size_t(LineClass::Inner)];
}

/// How many lines there are at each node.
class Nodes {
public:
    explicit Nodes(const std::vector<DrawnLine>& lines) {
        for (const DrawnLine& line : lines)
            for (std::size_t i = line.closed ? 1 : 0; i < line.points.size(); ++i)
                if (line.points[i].node != laplacian_lines::kNoSightNode)
                    ++lines_[line.points[i].node];
    }

    bool isJunction(const DrawnPoint& point) const {
        const auto found = lines_.find(point.node);
        return found != lines_.end() && found->second > 1;
    }

private:
    std::unordered_map<std::uint32_t, int> lines_;
};

/// Cuts off what is shorter than `shortest` between an end in nothing and the next junction.
void trimEnd(const Nodes& nodes, double shortest, std::vector<DrawnPoint>& points) {
    if (points.size() < 2 || nodes.isJunction(points.back())) return;
    std::size_t last = points.size() - 1;
    while (last > 0 && !nodes.isJunction(points[last]))
        --last;
    if (lengthOf(points, last) < shortest) points.resize(last + 1);
}

/// A loop that is filled by its own stroke is a dot, which says nothing of the form.
bool isDot(const DrawnLine& line, double shortest) {
    Eigen::AlignedBox2d box;
    for (const DrawnPoint& point : line.points)
        box.extend(point.position);
    return box.sizes().maxCoeff() < shortest / 2 || lengthOf(line.points) < shortest;
}

void trim(const Nodes& nodes, double shortest, DrawnLine& line) {
    if (line.closed) {
        if (isDot(line, shortest)) line.points.clear();
        return;
    }
    trimEnd(nodes, shortest, line.points);
    std::reverse(line.points.begin(), line.points.end());
    trimEnd(nodes, shortest, line.points);
    std::reverse(line.points.begin(), line.points.end());
}

bool isClear(const DrawnPoint& point) {
    return point.weight >= least_weight;
}

/// A loop from a point on that is clear, if it has one.
void beginClear(std::vector<DrawnPoint>& loop) {
    const auto first = std::find_if(loop.begin(), loop.end(), isClear);
    if (first == loop.end()) return;
    loop.pop_back();
    std::rotate(loop.begin(), first, loop.end());
    loop.push_back(loop.front());
}

/// From clear points to clear points, with what is faint for no longer than `longest` between.
std::vector<DrawnLine> clearParts(const DrawnLine& line, const std::vector<DrawnPoint>& points,
                                  double longest) {
    std::vector<DrawnLine> parts;
    std::vector<DrawnPoint> faint;
    for (const DrawnPoint& point : points) {
        faint.push_back(point);
        if (!isClear(point)) continue;
        if (parts.empty() || lengthOf(faint) > longest) {
            parts.push_back({line.line_class, false, {point}});
        } else {
            std::vector<DrawnPoint>& part = parts.back().points;
            part.insert(part.end(), faint.begin(), faint.end());
        }
        faint.clear();
    }
    return parts;
}

}  // namespace

std::vector<DrawnLine> withoutFaintParts(std::vector<DrawnLine> lines, double pen) {
    std::vector<DrawnLine> rest;
    for (DrawnLine& line : lines) {
        std::vector<DrawnPoint> points;
        if (isInner(line)) points = refine(line.points, step * pen);
        if (std::all_of(points.begin(), points.end(), isClear)) {
            rest.push_back(std::move(line));
            continue;
        }
        if (line.closed) beginClear(points);
        for (DrawnLine& part : clearParts(line, points, longest_faint * pen))
            if (part.points.size() == points.size())
                rest.push_back(std::move(line));
            else if (part.points.size() > 1)
                rest.push_back(std::move(part));
    }
    return rest;
}

std::vector<DrawnLine> withoutSlightLines(std::vector<DrawnLine> lines,
                                          const SheetOptions& options) {
    lines.erase(std::remove_if(lines.begin(), lines.end(),
                               [&](const DrawnLine& line) { return isSlight(line, options); }),
                lines.end());
    const Nodes nodes(lines);
    for (DrawnLine& line : lines) {
        const double shares = isCurvedContour(line) ? shortest_contour_end : 1;
        if (line.line_class != LineClass::Outline)
            trim(nodes, shares * options.shortest_line, line);
    }
    lines.erase(std::remove_if(lines.begin(), lines.end(),
                               [](const DrawnLine& line) { return line.points.size() < 2; }),
                lines.end());
    return lines;
}

}  // namespace line_drawing
