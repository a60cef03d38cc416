// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/make_sheet.h"

#include <algorithm>

#include "line_drawing/words.h"
#include "options/paper_and_pens.h"
#include "sheet/sheet_annotations.h"
#include "sheet/sheet_layout.h"
#include "views/drawn_view.h"

namespace line_drawing {
namespace {

using Box = Eigen::AlignedBox2d;
using Eigen::Vector2d;

// mm
constexpr double kViewSize = 85, kCellGap = 5, kLeastCell = 35, kNameHeight = 2.6,
                 kSizeHeight = 2.2;
constexpr double kCaptionHeight = 2 * kNameHeight + 1.5 * kSizeHeight;

/// Cells in rows, a view and its caption in each.
struct Grid {
    Vector2d paper;
    int columns = 1;
    double cell = 0;  // a square, above its caption

    double row_height() const { return cell + kCaptionHeight + kCellGap; }
};

/// The grid with the largest cells in the fewest rows.
Grid fill_paper(const Vector2d& paper, int count, double title_room) {
    const double width = paper.x() - 2 * kSheetMargin,
                 height = paper.y() - 2 * kSheetMargin - title_room;
    Grid best{paper, 1, 0};
    for (int columns = 1; columns <= count; ++columns) {
        const int rows = (count + columns - 1) / columns;
        const double cell = std::min({kViewSize, (width + kCellGap) / columns - kCellGap,
                                      (height + kCellGap) / rows - kCellGap - kCaptionHeight});
        if (cell >= best.cell) best = {paper, columns, cell};
    }
    return best;
}

/// On the smallest paper from A4 on that has room, else on A0, in smaller cells.
Grid choose_grid(int count, double title_room) {
    Grid grid;
    for (const char* name : {"a4", "a3", "a2", "a1", "a0"}) {
        const Vector2d paper = *paper_size(name);
        const Grid upright = fill_paper(paper, count, title_room),
                   lying = fill_paper(paper.reverse(), count, title_room);
        grid = lying.cell > upright.cell ? lying : upright;
        if (grid.cell >= kLeastCell) break;
    }
    return grid;
}

SheetText caption(const std::string& text, double height, double base, const Box& cell) {
    return {{cell.center().x(), base},
            height,
            TextAnchor::Middle,
            elided(one_line(text), height, cell.sizes().x())};
}

Box extent_of(const Sheet& sheet) {
    Box extent;
    for (const SheetGroup& group : sheet.groups)
        for (const SheetLayer& layer : group.layers)
            for (const SheetPath& path : layer.paths)
                extent.extend(path.path.bounds());
    return extent;
}

SheetGroup place_in(const Box& cell, const ContactEntry& entry, int number) {
    const double scale = cell.sizes().x() / kViewSize;
    const Vector2d shift = cell.center() - scale * extent_of(entry.view).center();
    SheetGroup result{"object-" + std::to_string(number), "Object " + entry.name, {}};
    for (const SheetGroup& group : entry.view.groups)
        for (SheetLayer layer : group.layers) {
            for (SheetPath& path : layer.paths) {
                path.path = path.path.placed(scale, shift);
                path.pen_width *= scale;
                path.dash *= scale;
            }
            result.layers.push_back(std::move(layer));
        }
    const double base = cell.max().y() + 1.5 * kNameHeight;
    result.layers.push_back(
        {"names",
         "Names",
         {},
         {caption(entry.name, kNameHeight, base, cell),
          caption(entry.view.title, kSizeHeight, base + 1.5 * kSizeHeight, cell)}});
    return result;
}

}  // namespace

SheetOptions contact_options(const laplacian_lines::TriangleMesh& mesh,
                             const SheetOptions& options) {
    SheetOptions result = options;
    result.views = {options.views.empty() ? frame_of_side(Side::Front, options.up)
                                          : options.views.front()};
    result.views[0].eye.reset();  // objects are drawn at scale
    result.sections.clear();
    result.paper = "fit";
    result.has_annotations = false;
    const Projection projection(result.views[0], Eigen::Vector3d::Zero());
    const double longest = options.mm_per_unit * projection.bounds_of(mesh).sizes().maxCoeff();
    result.title = size_text(options.mm_per_unit * bounds_of(mesh).sizes());
    result.scale = longest > 0 ? kViewSize / longest : 1;
    result.pens = finer(options.pens, 1);
    return result;
}

Sheet make_contact_sheet(const std::vector<ContactEntry>& entries, const std::string& title) {
    const Grid grid =
        choose_grid(std::max(1, int(entries.size())), title.empty() ? 0 : 2 * kTitleHeight);
    Sheet sheet{grid.paper, one_line(title), {}};
    const double left = (grid.paper.x() - grid.columns * (grid.cell + kCellGap) + kCellGap) / 2;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const int column = int(i) % grid.columns, row = int(i) / grid.columns;
        const Vector2d corner(left + column * (grid.cell + kCellGap),
                              kSheetMargin + row * grid.row_height());
        const Box cell(corner, corner + Vector2d(grid.cell, grid.cell));
        sheet.groups.push_back(place_in(cell, entries[i], int(i) + 1));
    }
    if (title.empty()) return sheet;
    sheet.groups.push_back({"sheet", "Sheet", {{"title", "Title", {}, {}}}});
    add_title(sheet.title, {kSheetMargin, grid.paper.y() - kSheetMargin},
              grid.paper.x() - 2 * kSheetMargin, sheet.groups.back().layers[0], sheet.remarks);
    return sheet;
}

}  // namespace line_drawing
