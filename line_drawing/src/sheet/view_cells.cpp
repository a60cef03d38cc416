// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/view_cells.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace line_drawing {
namespace {

constexpr int kOthersInARow = 4;  // the columns of the six sides: right, front, left, back

/// Around the front view, in first angle, by Side.
constexpr Cell kCells[] = {{0, 0}, {0, 2}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}, {0, 0}};

/// In third angle the sides change places, but the back stays on the right.
Cell cell_of(Side side, Arrangement arrangement) {
    const Cell& cell = kCells[std::size_t(side)];
    const bool is_swapped = arrangement == Arrangement::ThirdAngle && side != Side::Back;
    return is_swapped ? Cell{-cell.row, -cell.column} : cell;
}

/// Views of no side, at the end of the front view's row, or in rows from the second below it on.
void place_others(const std::vector<DrawnView>& views, bool beside, std::vector<Cell>& cells) {
    int left = 0, right = 0, others = 0;
    for (const Cell& cell : cells)
        left = std::min(left, cell.column), right = std::max(right, cell.column);
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (views[i].frame.side != Side::Other || views[i].is_section) continue;
        cells[i] = beside ? Cell{0, right + 1 + others}
                          : Cell{2 + others / kOthersInARow, left + others % kOthersInARow};
        ++others;
    }
}

/// Views whose cell is taken, beside or below the front view; then sections, likewise, or if
/// `in_a_row` is not 0 in rows of so many below all views.
void place_rest(const std::vector<DrawnView>& views, UpAxis up, int in_a_row,
                std::vector<Cell>& cells) {
    std::set<std::pair<int, int>> taken;
    std::vector<std::size_t> waiting;
    int last_row = 0, left = 0, last_column = 0, sections = 0;
    for (std::size_t i = 0; i < views.size(); ++i)
        if (!views[i].is_section && taken.emplace(cells[i].row, cells[i].column).second) {
            last_row = std::max(last_row, cells[i].row);
            left = std::min(left, cells[i].column);
            last_column = std::max(last_column, cells[i].column);
        } else {
            waiting.push_back(i);
        }
    for (const std::size_t i : waiting) {
        const bool is_vertical = std::abs(views[i].frame.towards_viewer[int(up)]) > 0.5;
        if (views[i].is_section && in_a_row > 0) {
            cells[i] = {last_row + 1 + sections / in_a_row, left + sections % in_a_row};
            ++sections;
        } else {
            cells[i] = is_vertical ? Cell{++last_row, 0} : Cell{0, ++last_column};
        }
    }
}

}  // namespace

std::vector<Cell> cells_of(const std::vector<DrawnView>& views, const SheetOptions& options,
                           const CellChoice& choice) {
    std::vector<Cell> cells;
    for (const DrawnView& view : views)
        cells.push_back(cell_of(view.frame.side, options.arrangement));
    place_others(views, choice.others_beside, cells);
    place_rest(views, options.up, choice.sections_in_a_row, cells);
    return cells;
}

}  // namespace line_drawing
