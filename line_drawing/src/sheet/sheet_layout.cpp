// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "line_drawing/words.h"
#include "sections/section_marks.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

/// Largest first: 1:2 is 0.5.
std::vector<double> usual_scales() {
    std::vector<double> scales;
    for (const double tens : {1000., 100., 10., 1.})
        for (const double first : {5., 4., 2., 1.})
            if (first != 4. || tens == 1.) scales.push_back(first * tens);
    for (const double tens : {1., 10., 100., 1000., 10000.})
        for (const double first : {2., 2.5, 3., 4., 5., 10.})
            if (first != 2.5 || tens > 1) scales.push_back(1 / (first * tens));
    return scales;
}

struct Paper {
    const char* name;
    double width, height;  // mm, portrait
};
constexpr Paper kPapers[] = {{"a5", 148, 210}, {"a4", 210, 297}, {"a3", 297, 420},
                             {"a2", 420, 594}, {"a1", 594, 841}, {"a0", 841, 1189}};

/// Portrait; none: as large as the drawing.
std::optional<Vector2d> paper_size(const std::string& name) {
    if (lower(name) == "fit") return {};
    for (const Paper& paper : kPapers)
        if (lower(name) == paper.name) return Vector2d(paper.width, paper.height);
    refuse("There is no paper \"" + name +
           "\". Papers are a5, a4, a3, a2, a1, a0, or fit: as large as the drawing.");
}

constexpr std::array<double, 10> kPenSeries = {0.1, 0.13, 0.18, 0.25, 0.35, 0.5, 0.7, 1, 1.4, 2};
/// mm on paper: smaller drawings get pens one or two steps finer.
constexpr double kFullSize = 40, kHalfSize = 28;

/// Pens are in steps of √2.
double finer(double pen, int steps) {
    const auto place = std::lower_bound(kPenSeries.begin(), kPenSeries.end(), pen);
    return kPenSeries[std::size_t(std::max<std::ptrdiff_t>(0, place - kPenSeries.begin() - steps))];
}

struct Cell {
    int row, column;
};

/// The cell of a view around the front view, in first angle.
Cell cell_of(Side side) {
    switch (side) {
        case Side::Back:
            return {0, 2};
        case Side::Left:
            return {0, 1};
        case Side::Right:
            return {0, -1};
        case Side::Top:
            return {1, 0};
        case Side::Bottom:
            return {-1, 0};
        default:
            return {0, 0};
    }
}

/// Places sections, and views whose cell is occupied: upright ones on the right in the front view's
/// row, those from above below in its column.
void place_beside_the_front(const std::vector<DrawnView>& views, UpAxis up,
                            std::vector<Cell>& cells) {
    std::vector<bool> is_placed(views.size());
    int last_row = 0, last_column = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const auto is_taken = [&](std::size_t k) {
            return cells[k].row == cells[i].row && cells[k].column == cells[i].column;
        };
        is_placed[i] = !views[i].is_section;
        for (std::size_t k = 0; k < i; ++k)
            if (is_placed[k] && is_taken(k)) is_placed[i] = false;
        if (!is_placed[i]) continue;
        last_row = std::max(last_row, cells[i].row);
        last_column = std::max(last_column, cells[i].column);
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (is_placed[i]) continue;
        const bool is_from_above = std::abs(views[i].frame.towards_viewer[int(up)]) > 0.5;
        cells[i] = is_from_above ? Cell{++last_row, 0} : Cell{0, ++last_column};
    }
}

/// Places sections in rows of so many below the views.
void place_in_rows(const std::vector<DrawnView>& views, int in_a_row, std::vector<Cell>& cells) {
    int row = 0, column = 0;
    for (std::size_t i = 0; i < views.size(); ++i)
        if (!views[i].is_section) {
            row = std::max(row, cells[i].row + 1);
            column = std::min(column, cells[i].column);
        }
    int number = 0;
    for (std::size_t i = 0; i < views.size(); ++i)
        if (views[i].is_section) {
            cells[i] = {row + number / in_a_row, column + number % in_a_row};
            ++number;
        }
}

/// `sections_in_a_row`: 0 if they are beside the front view.
std::vector<Cell> cells_of(const std::vector<DrawnView>& views, const SheetOptions& options,
                           int sections_in_a_row) {
    const Arrangement arrangement = options.arrangement;
    constexpr int in_a_row = 4;
    std::vector<Cell> cells;
    int left = 0;
    for (const DrawnView& view : views) {
        Cell cell = cell_of(view.frame.side);
        if (arrangement == Arrangement::ThirdAngle && view.frame.side != Side::Back)
            cell = {-cell.row, -cell.column};
        left = std::min(left, cell.column);
        cells.push_back(cell);
    }
    int others = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (views[i].frame.side != Side::Other || views[i].is_section) continue;
        cells[i] = {2 + others / in_a_row, left + others % in_a_row};
        ++others;
    }
    place_beside_the_front(views, options.up, cells);
    if (sections_in_a_row > 0) place_in_rows(views, sections_in_a_row, cells);
    return cells;
}

/// A row or column: the extents of its views before and behind their centres, mm of the object.
struct Band {
    double before = 0, behind = 0;
    double room = 0;    // for marks at both ends, mm on the sheet
    double name = 0;    // width of the widest name, likewise
    double middle = 0;  // position on the sheet, mm, set by set_middles()

    void hold(double b, double a, double r) {
        before = std::max(before, b);
        behind = std::max(behind, a);
        room = std::max(room, r);
    }
};
using Bands = std::map<int, Band>;

/// Sets the middles from `start` on; returns the end of the last.
double set_middles(Bands& bands, double start, double scale, double gap) {
    double end = start;
    for (auto& [number, band] : bands) {
        if (end != start) end += gap;
        const double width = scale * (band.before + band.behind) + 2 * band.room;
        const double room = band.room + std::max(0., band.name - width) / 2;
        band.middle = end + room + scale * band.before;
        end = band.middle + scale * band.behind + room;
    }
    return end;
}

/// Whether no view has a scale.
bool are_in_perspective(const std::vector<DrawnView>& views) {
    return std::all_of(views.begin(), views.end(),
                       [](const DrawnView& view) { return view.frame.eye.has_value(); });
}

class Layout {
public:
    Layout(const std::vector<DrawnView>& views, const SheetOptions& options,
           int sections_in_a_row = 0)
        : options_(options), cells_(cells_of(views, options, sections_in_a_row)) {
        for (std::size_t i = 0; i < views.size(); ++i) {
            const auto& box = views[i].bounds;
            const Vector2d room = room_of_marks(views[i]);
            Band& column = columns_[cells_[i].column];
            column.hold(-box.min().x(), box.max().x(), room.x());
            if (options.has_annotations && views.size() > 1)
                column.name =
                    std::max(column.name,
                             width_in_any_font(name_of(views[i].frame, !are_in_perspective(views)),
                                               kViewNameHeight));
            rows_[cells_[i].row].hold(box.max().y(), -box.min().y(), room.y());
        }
    }

    /// Without annotations.
    Vector2d size_at(double scale) {
        const double below = options_.has_annotations ? 2 * kViewNameHeight : 0;
        return {set_middles(columns_, 0, scale, kViewGap),
                set_middles(rows_, 0, scale, kViewGap + below) + below};
    }

    SheetLayout lay_out(double scale, const Vector2d& paper) {
        const Vector2d size = size_at(scale);
        const double left = (paper.x() - size.x()) / 2;
        const double top =
            kSheetMargin + (paper.y() - 2 * kSheetMargin - kStripHeight - size.y()) / 2;
        SheetLayout layout{paper, scale, {}};
        for (const Cell& cell : cells_)
            layout.placements.push_back(
                {scale, {left + columns_[cell.column].middle, top + rows_[cell.row].middle}});
        return layout;
    }

private:
    const SheetOptions& options_;
    const std::vector<Cell> cells_;
    Bands rows_, columns_;
};

Vector2d room(const Vector2d& paper) {
    return {paper.x() - 2 * kSheetMargin, paper.y() - 2 * kSheetMargin - kStripHeight};
}

bool fits(const Vector2d& size, const Vector2d& paper) {
    return (size.array() <= room(paper).array()).all();
}

std::optional<double> largest_scale(Layout& layout, const Vector2d& paper) {
    for (const double scale : usual_scales())
        if (fits(layout.size_at(scale), paper)) return scale;
    return {};
}

/// 0 if sections are beside the front view, aligned with it: rows below are only used if they
/// double the scale, or are the only ones that fit.
int sections_in_a_row(const std::vector<DrawnView>& views, const SheetOptions& options,
                      const Vector2d& paper) {
    constexpr double least_gain = 2;
    const auto sections = int(options.sections.size());
    const auto scale_of = [&](int in_a_row) {
        Layout layout(views, options, in_a_row);
        double largest = 0;
        for (const Vector2d& side : {paper, Vector2d(paper.reverse())})
            largest =
                std::max(largest, options.scale == 0 ? largest_scale(layout, side).value_or(0)
                                                     : fits(layout.size_at(options.scale), side));
        return largest;
    };
    const double beside = scale_of(0);
    int best = 0;
    double best_scale = least_gain * beside;
    for (int in_a_row = 1; in_a_row < sections; ++in_a_row)
        if (const double scale = scale_of(in_a_row);
            scale > 0 && scale >= best_scale && (best == 0 || scale > best_scale))
            best = in_a_row, best_scale = scale;
    return best;
}

/// On paper as large as the drawing.
SheetLayout lay_out_freely(Layout& layout, double scale) {
    constexpr double least_width = 90;  // of the strip below the drawing
    const Vector2d size = layout.size_at(scale);
    return layout.lay_out(scale, {std::max(least_width, size.x()) + 2 * kSheetMargin,
                                  size.y() + 2 * kSheetMargin + kStripHeight});
}

/// The scale at which views just fit; gaps between them do not scale.
double filling_scale(Layout& layout, const Vector2d& paper) {
    constexpr double far = 1e4;  // a scale at which views are wider than their names
    const Vector2d beyond = layout.size_at(far), growing = (layout.size_at(2 * far) - beyond) / far;
    const auto filling = [&](const Vector2d& fixed) {
        return (room(paper) - fixed).cwiseQuotient(growing).minCoeff();
    };
    const double scale = filling(beyond - far * growing);
    const bool has_room = fits(layout.size_at((1 - 1e-9) * scale), paper);
    return has_room ? scale : filling(layout.size_at(0));
}

/// For views without scale: as large as the paper allows, A4 if it is not given.
SheetLayout lay_out_filling(Layout& layout, const std::optional<Vector2d>& paper) {
    const Vector2d upright = paper.value_or(Vector2d(kPapers[1].width, kPapers[1].height));
    const Vector2d lying = upright.reverse();
    const double a = filling_scale(layout, upright), b = filling_scale(layout, lying);
    if (!(std::max(a, b) > 0) || !std::isfinite(std::max(a, b)))
        refuse("Nothing of the object is in sight, or the paper has no room for so many views.");
    SheetLayout result = !paper  ? lay_out_freely(layout, std::max(a, b))
                         : b > a ? layout.lay_out(b, lying)
                                 : layout.lay_out(a, upright);
    result.scale = 0;
    return result;
}

/// Portrait or landscape, whichever is larger.
SheetLayout lay_out_largest(Layout& layout, const Vector2d& upright) {
    const Vector2d lying = upright.reverse();
    const auto a = largest_scale(layout, upright), b = largest_scale(layout, lying);
    if (!a && !b && (fits(layout.size_at(0), upright) || fits(layout.size_at(0), lying)))
        refuse("The object is too large for any scale. Is the unit of the mesh right?");
    if (!a && !b)
        refuse(
            "The paper has no room for so many views and sections. Take a larger one, or fewer.");
    return b.value_or(0) > a.value_or(0) ? layout.lay_out(*b, lying) : layout.lay_out(*a, upright);
}

SheetLayout lay_out_at(Layout& layout, double scale, const Vector2d& upright,
                       const std::string& name) {
    const Vector2d size = layout.size_at(scale);
    for (const Vector2d& paper : {upright, Vector2d(upright.reverse())})
        if (fits(size, paper)) return layout.lay_out(scale, paper);
    const auto best = std::max(largest_scale(layout, upright).value_or(0),
                               largest_scale(layout, upright.reverse()).value_or(0));
    refuse("At the scale " + scale_text(scale) + " the views take " +
           in_digits(std::ceil(size.x())) + " x " + in_digits(std::ceil(size.y())) + " mm, and " +
           upper(name) + " paper has room for " + in_digits(room(upright).x()) + " x " +
           in_digits(room(upright).y()) + ". Take " +
           (best > 0 ? "the scale " + scale_text(best) + ", " : "") +
           "a larger paper, or the paper \"fit\".");
}

}  // namespace

Pens pens_for(double size, Pens pens) {
    const int steps = size >= kFullSize ? 0 : size >= kHalfSize ? 1 : 2;
    for (double& pen : pens)
        if (steps > 0 && pen <= kPenSeries.back()) pen = std::min(pen, finer(pen, steps));
    return pens;
}

std::vector<const char*> paper_names() {
    std::vector<const char*> names;
    for (const Paper& paper : kPapers)
        names.push_back(paper.name);
    return names;
}

SheetLayout lay_out(const std::vector<DrawnView>& views, const SheetOptions& options) {
    const std::optional<Vector2d> paper = paper_size(options.paper);
    Layout layout(views, options, paper ? sections_in_a_row(views, options, *paper) : 0);
    if (are_in_perspective(views)) return lay_out_filling(layout, paper);
    if (!paper) return lay_out_freely(layout, options.scale > 0 ? options.scale : 1);
    if (options.scale > 0) return lay_out_at(layout, options.scale, *paper, options.paper);
    return lay_out_largest(layout, *paper);
}

}  // namespace line_drawing
