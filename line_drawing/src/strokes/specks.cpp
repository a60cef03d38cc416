// SPDX-License-Identifier: GPL-3.0-or-later
// What is too small to show form, and would be a fleck in print:
//  1. Contours of curved surfaces before a low jump in depth.
//  2. Connected lines in a small box, if no way leads around in them, and dots: an edge of the form
//     ends at others, or goes round a hole; what does neither is of a fold or a sliver of a scan.
//  3. Short ends between nothing and the next junction.
#include "strokes/strokes.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "strokes/drawn_lines.h"

namespace line_drawing {
namespace {

// mm; the second one of what meets nothing, and of contours of curved surfaces
constexpr double kShortestLine = 0.8, kShortestAlone = 3 * kShortestLine;

/// Without contours of curved surfaces before a jump of less than `least`; where these run along
/// edges of the form, the edges stay.
std::vector<DrawnLine> without_low(std::vector<DrawnLine> lines, double least) {
    const auto is_exact = [](const DrawnPoint& point) { return point.is_exact; };
    std::vector<DrawnLine> rest;
    for (DrawnLine& line : lines) {
        if (!is_curved_contour(line) || line.jump >= least) {
            rest.push_back(std::move(line));
            continue;
        }
        if (line.closed) {
            line.points.pop_back();
            std::rotate(line.points.begin(),
                        std::find_if_not(line.points.begin(), line.points.end(), is_exact),
                        line.points.end());
        }
        const auto end = line.points.end();
        for (auto begin = line.points.begin(); begin != end;) {
            begin = std::find_if(begin, end, is_exact);
            const auto last = std::find_if_not(begin, end, is_exact);
            if (last - begin > 1) rest.push_back(with_points(line, {begin, last}));
            begin = last;
        }
    }
    return rest;
}

/// Where lines meet.
class Nodes {
public:
    explicit Nodes(const std::vector<DrawnLine>& lines) {
        for (std::size_t l = 0; l < lines.size(); ++l)
            for (std::size_t i = lines[l].closed ? 1 : 0; i < lines[l].points.size(); ++i)
                if (lines[l].points[i].node != laplacian_lines::kNoNode)
                    lines_[lines[l].points[i].node].push_back(l);
    }

    bool is_junction(const DrawnPoint& point) const { return lines_at(point).size() > 1; }

    /// The numbers of the lines there.
    const std::vector<std::size_t>& lines_at(const DrawnPoint& point) const {
        static const std::vector<std::size_t> none;
        const auto found = lines_.find(point.node);
        return found != lines_.end() ? found->second : none;
    }

private:
    std::unordered_map<std::uint32_t, std::vector<std::size_t>> lines_;
};

/// Lines connected at nodes.
struct Net {
    std::vector<std::size_t> lines;
    Eigen::AlignedBox2d box;
    bool is_open;  ///< no way leads around in it
};

Net net_of(std::size_t first, const std::vector<DrawnLine>& lines, const Nodes& nodes,
           std::vector<bool>& is_known) {
    Net net{{first}, {}, true};
    std::unordered_set<std::uint32_t> met;
    std::size_t pieces = 0;  // between nodes
    is_known[first] = true;
    for (std::size_t k = 0; k < net.lines.size(); ++k) {
        const DrawnLine& line = lines[net.lines[k]];
        net.box.extend(box_of(line));
        std::size_t on_line = 0;
        for (const DrawnPoint& point : line.points) {
            if (point.node != laplacian_lines::kNoNode) met.insert(point.node), ++on_line;
            for (const std::size_t other : nodes.lines_at(point)) {
                if (is_known[other]) continue;
                is_known[other] = true;
                net.lines.push_back(other);
            }
        }
        pieces += std::max<std::size_t>(on_line, 1) - 1;
        if (line.closed) net.is_open = false;
    }
    net.is_open = net.is_open && pieces < std::max<std::size_t>(met.size(), 1);  // as in a tree
    return net;
}

/// Whether a line may go with its net; short inner ones may be a texture.
bool goes_if_alone(const DrawnLine& line) {
    return line.line_class != LineClass::Outline && line.line_class != LineClass::Section &&
           !is_inner(line);
}

/// Clears lines. `least`: extent of a net in which no way leads around.
void drop_small_nets(const Nodes& nodes, double least, std::vector<DrawnLine>& lines) {
    std::vector<bool> is_known(lines.size());
    for (std::size_t first = 0; first < lines.size(); ++first) {
        if (is_known[first]) continue;
        const Net net = net_of(first, lines, nodes, is_known);
        if (net.box.diagonal().norm() >= (net.is_open ? least : kShortestLine / 2)) continue;
        for (const std::size_t l : net.lines)
            if (goes_if_alone(lines[l])) lines[l].points.clear();
    }
}

/// Cuts off ends shorter than `shortest` between nothing and the next junction.
void trim_end(const Nodes& nodes, double shortest, std::vector<DrawnPoint>& points) {
    if (points.size() < 2 || nodes.is_junction(points.back())) return;
    std::size_t last = points.size() - 1;
    while (last > 0 && !nodes.is_junction(points[last]))
        --last;
    if (length_of(points, last) < shortest) points.resize(last + 1);
}

/// A loop so small, which its stroke fills or the roughness of a scan makes, shows no form.
bool is_dot(const DrawnLine& line, double shortest) {
    return box_of(line).sizes().maxCoeff() < shortest / 2 || length_of(line.points) < shortest;
}

void trim(const Nodes& nodes, double shortest, DrawnLine& line) {
    if (line.closed && is_dot(line, shortest)) line.points.clear();
    for (int end = 0; end < 2 && !line.closed; ++end) {
        trim_end(nodes, shortest, line.points);
        std::reverse(line.points.begin(), line.points.end());
    }
}

}  // namespace

std::vector<DrawnLine> without_specks(std::vector<DrawnLine> lines, const SheetOptions& options) {
    lines = without_low(std::move(lines), options.pens[std::size_t(LineClass::Inner)]);
    drop_small_nets(Nodes(lines), std::max(kShortestAlone, options.kernel.size), lines);
    const Nodes nodes(lines);
    for (DrawnLine& line : lines)
        if (line.line_class != LineClass::Outline)
            trim(nodes, is_curved_contour(line) ? kShortestAlone : kShortestLine, line);
    const auto is_empty = [](const DrawnLine& line) { return line.points.size() < 2; };
    lines.erase(std::remove_if(lines.begin(), lines.end(), is_empty), lines.end());
    return lines;
}

}  // namespace line_drawing
