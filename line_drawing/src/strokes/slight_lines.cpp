// SPDX-License-Identifier: GPL-3.0-or-later
#include "strokes/strokes.h"

#include <algorithm>
#include <unordered_map>

namespace line_drawing {
namespace {

// mm; the second one of contours of curved surfaces, which the roughness of a scan makes
constexpr double shortest_line = 0.8, shortest_contour_end = 3 * shortest_line;

bool isCurvedContour(const DrawnLine& line) {
    return line.line_class == LineClass::Contour && isSmooth(line);
}

bool isSlight(const DrawnLine& line, const SheetOptions& options) {
    return isCurvedContour(line) && line.jump < options.pens[std::size_t(LineClass::Inner)];
}

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

/// Of what ends in nothing. A contour that meets nothing at all and is shorter than √h goes round a
/// triangle or two which face away by chance.
double shortestEnd(const Nodes& nodes, const DrawnLine& line, const SheetOptions& options) {
    if (!isCurvedContour(line)) return shortest_line;
    const bool is_alone = std::none_of(line.points.begin(), line.points.end(),
                                       [&](const DrawnPoint& p) { return nodes.isJunction(p); });
    return is_alone ? std::max(shortest_contour_end, options.kernel.size) : shortest_contour_end;
}

/// Cuts off ends shorter than `shortest` between nothing and the next junction.
void trimEnd(const Nodes& nodes, double shortest, std::vector<DrawnPoint>& points) {
    if (points.size() < 2 || nodes.isJunction(points.back())) return;
    std::size_t last = points.size() - 1;
    while (last > 0 && !nodes.isJunction(points[last]))
        --last;
    if (lengthOf(points, last) < shortest) points.resize(last + 1);
}

/// A loop that its stroke fills is a dot, which shows no form.
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

}  // namespace

std::vector<DrawnLine> withoutSlightLines(std::vector<DrawnLine> lines,
                                          const SheetOptions& options) {
    lines.erase(std::remove_if(lines.begin(), lines.end(),
                               [&](const DrawnLine& line) { return isSlight(line, options); }),
                lines.end());
    const Nodes nodes(lines);
    for (DrawnLine& line : lines)
        if (line.line_class != LineClass::Outline)
            trim(nodes, shortestEnd(nodes, line, options), line);
    lines.erase(std::remove_if(lines.begin(), lines.end(),
                               [](const DrawnLine& line) { return line.points.size() < 2; }),
                lines.end());
    return lines;
}

}  // namespace line_drawing
