// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/make_sheet.h"

#include <algorithm>

#include "sheet/sheet_layout.h"
#include "views/drawn_view.h"

namespace line_drawing {
namespace {

using Box = Eigen::AlignedBox2d;
using Eigen::Vector2d;

// mm
constexpr double view_size = 85, cell_gap = 5, least_cell = 35, name_height = 2.6,
                 size_height = 2.2, title_height = 4;
constexpr double caption_height = 2 * name_height + 1.5 * size_height;

struct Grid {
    Vector2d paper;
    int columns = 1;
    double cell = 0;  // a square, above its caption

    double rowHeight() const { return cell + caption_height + cell_gap; }
};

double roomBelow(const std::string& title) {
    return title.empty() ? 0 : 2 * title_height;
}

/// The grid with the largest cells in the fewest rows.
Grid fillPaper(const Vector2d& paper, int count, double title_room) {
    const double width = paper.x() - 2 * sheet_margin,
                 height = paper.y() - 2 * sheet_margin - title_room;
    Grid best{paper, 1, 0};
    for (int columns = 1; columns <= count; ++columns) {
        const int rows = (count + columns - 1) / columns;
        const double cell = std::min({view_size, (width + cell_gap) / columns - cell_gap,
                                      (height + cell_gap) / rows - cell_gap - caption_height});
        if (cell >= best.cell) best = {paper, columns, cell};
    }
    return best;
}

/// On the smallest paper from A4 on that has room.
Grid chooseGrid(int count, double title_room) {
    const Vector2d papers[] = {{210, 297}, {297, 420}, {420, 594}, {594, 841}, {841, 1189}};
    Grid grid;
    for (const Vector2d& paper : papers) {
        const Grid upright = fillPaper(paper, count, title_room),
                   lying = fillPaper(paper.reverse(), count, title_room);
        grid = lying.cell > upright.cell ? lying : upright;
        if (grid.cell >= least_cell) break;
    }
    return grid;
}

SheetText caption(const std::string& text, double height, double base, const Box& cell) {
    return {{cell.center().x(), base},
            height,
            TextAnchor::Middle,
            elided(text, height, cell.sizes().x())};
}

Box extentOf(const Sheet& sheet) {
    Box extent;
    for (const SheetGroup& group : sheet.groups)
        for (const SheetLayer& layer : group.layers)
            for (const SheetPath& path : layer.paths)
                extent.extend(path.path.bounds());
    return extent;
}

SheetGroup placeIn(const Box& cell, const ContactEntry& entry, int number) {
    const double scale = cell.sizes().x() / view_size;
    const Vector2d shift = cell.center() - scale * extentOf(entry.view).center();
    SheetGroup result{"object-" + std::to_string(number), "Object " + entry.name, {}};
    for (const SheetGroup& group : entry.view.groups)
        for (SheetLayer layer : group.layers) {
            for (SheetPath& path : layer.paths) {
                path.path = path.path.placed(scale, shift);
                path.pen_width *= scale;
            }
            result.layers.push_back(std::move(layer));
        }
    const double base = cell.max().y() + 1.5 * name_height;
    result.layers.push_back(
        {"names",
         "Names",
         {},
         {caption(entry.name, name_height, base, cell),
          caption(entry.view.title, size_height, base + 1.5 * size_height, cell)}});
    return result;
}

}  // namespace

SheetOptions contactOptions(const laplacian_lines::TriangleMesh& mesh,
                            const SheetOptions& options) {
    SheetOptions result = options;
    result.views = {options.views.empty() ? frameOfSide(Side::Front, options.up)
                                          : options.views.front()};
    result.sections.clear();
    result.paper = "fit";
    result.has_furniture = false;
    const Eigen::Vector2d size =
        Projection(result.views[0], Eigen::Vector3d::Zero()).boundsOf(mesh).sizes();
    const double longest = options.mm_per_unit * size.maxCoeff();
    result.title = sizeInWords(options.mm_per_unit * boundsOf(mesh).sizes());
    result.scale = longest > 0 ? view_size / longest : 1;
    result.pens = {0.35, 0.25, 0.18, 0.18, 0.13, 0.25, 0.13};
    return result;
}

Sheet makeContactSheet(const std::vector<ContactEntry>& entries, const std::string& title) {
    const Grid grid = chooseGrid(std::max(1, int(entries.size())), roomBelow(title));
    Sheet sheet{grid.paper, title, {}, 1};
    const double left = (grid.paper.x() - grid.columns * (grid.cell + cell_gap) + cell_gap) / 2;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const int column = int(i) % grid.columns, row = int(i) / grid.columns;
        const Vector2d corner(left + column * (grid.cell + cell_gap),
                              sheet_margin + row * grid.rowHeight());
        const Box cell(corner, corner + Vector2d(grid.cell, grid.cell));
        sheet.groups.push_back(placeIn(cell, entries[i], int(i) + 1));
    }
    if (title.empty()) return sheet;
    const SheetText text{
        {sheet_margin, grid.paper.y() - sheet_margin}, title_height, TextAnchor::Left, title};
    sheet.groups.push_back({"sheet", "Sheet", {{"title", "Title", {}, {text}}}});
    return sheet;
}

}  // namespace line_drawing
