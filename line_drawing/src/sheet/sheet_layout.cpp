// SPDX-License-Identifier: GPL-3.0-or-later
// Where views are on the page, and at which scale:
//  1. Each view has a cell in a table around the front view (view_cells.h).
//  2. A column is as wide as its views to either side of their middles, a row as high, so that
//     equal places of the object are level. Marks of sections and names of views need room besides,
//     which does not grow with the scale.
//  3. The scale is the options', or the largest usual one at which the table fits on the paper,
//     upright or lying. Where all views are in perspective, and have none, they fill the paper.
#include "sheet/sheet_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "line_drawing/words.h"
#include "options/paper_and_pens.h"
#include "sections/section_marks.h"
#include "sheet/sheet_annotations.h"
#include "sheet/view_cells.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

/// A row or column. Its views are aligned by their middles.
struct Band {
    double before = 0, behind = 0;  // how far views reach from their middles, mm of the object
    double marks = 0;               // their room at both ends, mm on the sheet
    double name = 0;                // width of the widest name, mm on the sheet
    double middle = 0;              // on the sheet, mm, set by set_middles()

    void hold(double view_before, double view_behind, double view_marks) {
        before = std::max(before, view_before);
        behind = std::max(behind, view_behind);
        marks = std::max(marks, view_marks);
    }
};
using Bands = std::map<int, Band>;  // by the number of the row or column

/// Sets middles at this scale, from `start` on, with gaps; returns the end of the last band.
double set_middles(Bands& bands, double start, double scale, double gap) {
    double end = start;
    for (auto& [number, band] : bands) {
        if (number != bands.begin()->first) end += gap;
        const double width = scale * (band.before + band.behind) + 2 * band.marks;
        const double aside = band.marks + std::max(0., band.name - width) / 2;
        band.middle = end + aside + scale * band.before;
        end = band.middle + scale * band.behind + aside;
    }
    return end;
}

/// Whether no view has a scale.
bool are_in_perspective(const std::vector<DrawnView>& views) {
    return std::all_of(views.begin(), views.end(),
                       [](const DrawnView& view) { return view.frame.eye.has_value(); });
}

/// The part of the paper for views.
Vector2d room_on(const Vector2d& paper) {
    return {paper.x() - 2 * kSheetMargin, paper.y() - 2 * kSheetMargin - kStripHeight};
}

/// The table of views, at any scale.
class Layout {
public:
    Layout(const std::vector<DrawnView>& views, const SheetOptions& options,
           const CellChoice& choice)
        : name_row_(have_names(views, options) ? kViewNameRow : 0),
          strip_width_(least_strip_width(views, options)),
          cells_(cells_of(views, options, choice)) {
        for (std::size_t i = 0; i < views.size(); ++i) {
            const auto& box = views[i].bounds;
            const Vector2d marks = room_of_marks(views[i]);
            Band& column = columns_[cells_[i].column];
            column.hold(-box.min().x(), box.max().x(), marks.x());
            if (name_row_ > 0)
                column.name =
                    std::max(column.name,
                             width_in_any_font(name_of(views[i].frame, !are_in_perspective(views)),
                                               kViewNameHeight));
            rows_[cells_[i].row].hold(box.max().y(), -box.min().y(), marks.y());
        }
    }

    /// Of all views with their names, without the strip of notes below them.
    Vector2d size_at(double scale) {
        return {set_middles(columns_, 0, scale, kViewGap),
                set_middles(rows_, 0, scale, kViewGap + name_row_) + name_row_};
    }

    /// On paper as large as the drawing.
    SheetLayout lay_out_freely(double scale) {
        const Vector2d size = size_at(scale);
        return lay_out(scale, {std::max(strip_width_, size.x()) + 2 * kSheetMargin,
                               size.y() + 2 * kSheetMargin + kStripHeight});
    }

    /// In the middle of the paper above the strip.
    SheetLayout lay_out(double scale, const Vector2d& paper) {
        const Vector2d size = size_at(scale);
        const double left = (paper.x() - size.x()) / 2;
        const double top = kSheetMargin + (room_on(paper).y() - size.y()) / 2;
        SheetLayout layout{paper, scale, {}};
        for (const Cell& cell : cells_)
            layout.placements.push_back(
                {scale, {left + columns_[cell.column].middle, top + rows_[cell.row].middle}});
        return layout;
    }

private:
    const double name_row_, strip_width_;  // mm
    const std::vector<Cell> cells_;
    Bands rows_, columns_;
};

bool fits(const Vector2d& size, const Vector2d& paper) {
    return (size.array() <= room_on(paper).array()).all();
}

/// The largest usual scale at which views fit; 0 if there is none.
double largest_scale(Layout& layout, const Vector2d& paper) {
    for (const double scale : usual_scales())
        if (fits(layout.size_at(scale), paper)) return scale;
    return 0;
}

/// The scale at which views fit on the paper, upright or lying: the options', or the largest usual
/// one. 0 if there is none.
double possible_scale(Layout& layout, const SheetOptions& options, const Vector2d& upright) {
    double largest = 0;
    for (const Vector2d& paper : {upright, Vector2d(upright.reverse())})
        if (options.scale == 0)
            largest = std::max(largest, largest_scale(layout, paper));
        else if (fits(layout.size_at(options.scale), paper))
            largest = options.scale;
    return largest;
}

/// Views of no side are below the others, unless beside them the scale is larger. Sections are
/// beside the front view, aligned with it, unless rows double the scale, or otherwise nothing fits.
CellChoice choose_cells(const std::vector<DrawnView>& views, const SheetOptions& options,
                        const Vector2d& paper) {
    constexpr double least_gain = 2;
    CellChoice best;
    double best_scale = 0;
    for (int in_a_row = 0; in_a_row <= int(options.sections.size()); ++in_a_row)
        for (const bool beside : {false, true}) {
            const CellChoice choice{beside, in_a_row};
            Layout layout(views, options, choice);
            const double scale = possible_scale(layout, options, paper);
            const bool is_first_row = in_a_row > 0 && best.sections_in_a_row == 0;
            if (is_first_row ? scale > 0 && scale >= least_gain * best_scale : scale > best_scale)
                best = choice, best_scale = scale;
        }
    return best;
}

/// The scale at which the table just fits. Its size grows in proportion from some scale on; below,
/// names may be wider than their views. If what follows from the proportion does not fit, the gaps
/// and names alone are taken from the paper.
double filling_scale(Layout& layout, const Vector2d& paper) {
    double far = 1e4;  // from which on views are wider than their names
    while (far < 1e20 && layout.size_at(far).maxCoeff() < 1e4)
        far *= 10;
    const Vector2d beyond = layout.size_at(far), growing = (layout.size_at(2 * far) - beyond) / far;
    const auto filling = [&](const Vector2d& fixed) {
        return (room_on(paper) - fixed).cwiseQuotient(growing).minCoeff();
    };
    const double scale = filling(beyond - far * growing);
    const bool does_fit = fits(layout.size_at((1 - 1e-9) * scale), paper);
    return does_fit ? scale : filling(layout.size_at(0));
}

/// For views without scale: as large as the paper allows, A4 if it is not given.
SheetLayout lay_out_filling(Layout& layout, const std::optional<Vector2d>& paper) {
    const Vector2d upright = paper.value_or(*paper_size("a4")), lying = upright.reverse();
    const double a = filling_scale(layout, upright), b = filling_scale(layout, lying);
    if (!(std::max(a, b) > 0) || !std::isfinite(std::max(a, b)))
        refuse("Nothing of the object is in sight, or the paper has no room for so many views.");
    SheetLayout result = !paper  ? layout.lay_out_freely(std::max(a, b))
                         : b > a ? layout.lay_out(b, lying)
                                 : layout.lay_out(a, upright);
    result.scale = 0;
    return result;
}

/// Upright or lying, whichever gives the larger scale.
SheetLayout lay_out_largest(Layout& layout, const Vector2d& upright) {
    const Vector2d lying = upright.reverse();
    const double a = largest_scale(layout, upright), b = largest_scale(layout, lying);
    if (std::max(a, b) > 0) return b > a ? layout.lay_out(b, lying) : layout.lay_out(a, upright);
    if (fits(layout.size_at(0), upright) || fits(layout.size_at(0), lying))
        refuse("The object is too large for any scale. Is the unit of the mesh right?");
    refuse("The paper has no room for so many views and sections. Take a larger one, or fewer.");
}

SheetLayout lay_out_at(Layout& layout, double scale, const Vector2d& upright,
                       const std::string& name) {
    const Vector2d size = layout.size_at(scale);
    for (const Vector2d& paper : {upright, Vector2d(upright.reverse())})
        if (fits(size, paper)) return layout.lay_out(scale, paper);
    const double best =
        std::max(largest_scale(layout, upright), largest_scale(layout, upright.reverse()));
    refuse("At the scale " + scale_text(scale) + " the views take " +
           in_digits(std::ceil(size.x())) + " x " + in_digits(std::ceil(size.y())) + " mm, and " +
           upper(name) + " paper has room for " + in_digits(room_on(upright).x()) + " x " +
           in_digits(room_on(upright).y()) + ". Take " +
           (best > 0 ? "the scale " + scale_text(best) + ", " : "") +
           "a larger paper, or the paper \"fit\".");
}

}  // namespace

SheetLayout lay_out(const std::vector<DrawnView>& views, const SheetOptions& options) {
    const std::optional<Vector2d> paper = paper_size(options.paper);
    Layout layout(views, options, paper ? choose_cells(views, options, *paper) : CellChoice());
    if (are_in_perspective(views)) return lay_out_filling(layout, paper);
    if (!paper) return layout.lay_out_freely(options.scale > 0 ? options.scale : 1);
    if (options.scale > 0) return lay_out_at(layout, options.scale, *paper, options.paper);
    return lay_out_largest(layout, *paper);
}

}  // namespace line_drawing
