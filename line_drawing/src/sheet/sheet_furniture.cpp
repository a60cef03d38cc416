// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_layout.h"

#include <algorithm>
#include <cmath>

#include "line_drawing/words.h"
#include "planes/lettering.h"
#include "sections/section_marks.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

// mm
constexpr double thin_pen = 0.18;
constexpr double title_height = 4, note_height = 2.6, longest_bar = 50, bar_height = 1.2;
constexpr double least_height = 1.8, smaller = 0.94;              // of letters; a step towards it
constexpr double height_of_two_lines = 3.2, line_distance = 1.3;  // of a title; of its height
constexpr double widest_font = 1.15;                              // of our letters' width
constexpr double symbol_height = 5, symbol_width = 14, strip_gap = 6;
const char* const no_scale = "perspective, not to scale";

/// Filled, or with this pen.
SheetPath rectangle(const Vector2d& corner, double width, double height, double pen = 0) {
    SheetPath result{{}, pen};
    result.path.addRectangle(corner, width, height);
    return result;
}

/// How many letters fit, 1 at least.
std::size_t fitting(std::u32string_view letters, double height, double width) {
    std::size_t count = 0;
    for (; count < letters.size() && width >= 0; ++count)
        width -= widest_font * height * widthOf(letters[count]);
    return width < 0 && count > 1 ? count - 1 : count;
}

struct FittedText {
    double height;
    std::vector<std::u32string> lines;
    bool is_cut = false;
};

/// Lines end between words if they can; the last one with "…" if that is not all.
FittedText wrapped(std::u32string_view rest, double height, double width, std::size_t most_lines) {
    FittedText text{height, {}};
    while (!rest.empty() && text.lines.size() < most_lines) {
        std::size_t count = fitting(rest, height, width);
        const std::size_t space = rest.substr(0, count + 1).rfind(U' ');
        if (count < rest.size() && space != rest.npos && space > 0) count = space;
        text.lines.emplace_back(rest.substr(0, count));
        rest.remove_prefix(count);
        rest.remove_prefix(std::min(rest.find_first_not_of(U' '), rest.size()));
    }
    text.is_cut = !rest.empty();
    return text;
}

/// In letters of `height`, or smaller ones if that is not enough.
FittedText fit(const std::string& text, double height, double least, double width,
               std::size_t most_lines) {
    const std::u32string letters = lettersOf(text);
    FittedText fitted = wrapped(letters, height, width, most_lines);
    for (; fitted.is_cut && height > least; height *= smaller)
        fitted = wrapped(letters, std::max(least, height * smaller), width, most_lines);
    if (!fitted.is_cut) return fitted;
    fitted.lines.back() =
        lettersOf(elided(inUtf8(fitted.lines.back() + U" \u2026"), fitted.height, width));
    return fitted;
}

SheetLayer viewNames(const std::vector<DrawnView>& views, const SheetLayout& layout) {
    SheetLayer layer{"names", "Names of views", {}, {}};
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Eigen::AlignedBox2d& place = layout.placements[i].onSheet(views[i].bounds);
        layer.texts.push_back({{place.center().x(),
                                place.max().y() + roomOfMarks(views[i]).y() + 2 * view_name_height},
                               view_name_height,
                               TextAnchor::Middle,
                               nameOf(views[i].frame, layout.scale > 0)});
    }
    return layer;
}

/// The longest usual length, 1, 2 or 5 times a power of ten, drawn at most `most` long; in the
/// object's mm.
double barLength(double scale, double most) {
    double power = std::pow(10, std::floor(std::log10(most / scale) + 1e-9));
    for (const double first : {5., 2.})
        if (first * power * scale <= most) return first * power;
    return power;
}

/// "5 cm" for 50.
std::string lengthInWords(double mm) {
    if (mm >= 1e6) return inDigits(mm / 1e6) + " km";
    if (mm >= 1000) return inDigits(mm / 1000) + " m";
    if (mm >= 10) return inDigits(mm / 10) + " cm";
    return mm < 0.1 ? inDigits(mm * 1000) + " µm" : inDigits(mm) + " mm";
}

/// Blocks of a tenth, fifth or quarter of the bar, alternately black and white.
int partsOf(double length) {
    const double first = length / std::pow(10, std::floor(std::log10(length) + 1e-9));
    return first > 1.5 && first < 3 ? 4 : 5;
}

/// Lower right corner at `corner`. Returns the left end.
double addScaleBar(const Vector2d& corner, double scale, SheetLayer& layer) {
    const double length = barLength(scale, longest_bar), width = length * scale;
    const int parts = partsOf(length);
    const double left = corner.x() - width, top = corner.y() - bar_height;
    layer.paths.push_back(rectangle({left, top}, width, bar_height, thin_pen));
    for (int part = 0; part < parts; part += 2)
        layer.paths.push_back(
            rectangle({left + width * part / parts, top}, width / parts, bar_height));
    const double base = top - 1;
    layer.texts.push_back({{left, base}, note_height, TextAnchor::Left, "0"});
    layer.texts.push_back(
        {{corner.x(), base}, note_height, TextAnchor::Right, lengthInWords(length)});
    return left;
}

/// A truncated cone with the view from its small end, on its left: on the right in first angle, on
/// the left in third (ISO 5456-2).
void addProjectionSymbol(const Vector2d& corner, Arrangement arrangement, SheetLayer& layer) {
    const double h = symbol_height, y = corner.y() - h / 2;
    const bool is_first = arrangement == Arrangement::FirstAngle;
    const double cone = is_first ? corner.x() : corner.x() + symbol_width - h * 1.2;
    const double circles = is_first ? corner.x() + symbol_width - h / 2 : corner.x() + h / 2;
    Path trapezium;
    trapezium.moveTo({cone, y - h / 4});
    trapezium.lineTo({cone + 1.2 * h, y - h / 2});
    trapezium.lineTo({cone + 1.2 * h, y + h / 2});
    trapezium.lineTo({cone, y + h / 4});
    trapezium.close();
    layer.paths.push_back({trapezium, thin_pen});
    for (const double radius : {h / 4, h / 2}) {
        Path circle;
        circle.addCircle({circles, y}, radius);
        layer.paths.push_back({circle, thin_pen});
    }
}

std::string noteOf(const std::vector<DrawnView>& views, const SheetLayout& layout,
                   const Eigen::Vector3d& size, const SheetOptions& options, double kernel) {
    Words parts = {layout.scale > 0 ? scaleInWords(layout.scale) : no_scale, sizeInWords(size)};
    if (kernel > 0) parts.push_back("√h " + kernelInWords(kernel) + " mm");
    for (const DrawnView& view : views)
        if (!view.note.empty()) parts.push_back(view.note);
    if (!options.source.empty()) parts.push_back(options.source);
    return joined(parts, " · ");
}

/// Adds lines of text from below, the last one with its left end at `corner`.
void addLines(const FittedText& text, const Vector2d& corner, SheetLayer& layer) {
    double base = corner.y();
    for (std::size_t i = text.lines.size(); i-- > 0; base -= line_distance * text.height)
        layer.texts.push_back(
            {{corner.x(), base}, text.height, TextAnchor::Left, inUtf8(text.lines[i])});
}

std::string remarkOn(const char* what, const FittedText& text) {
    return std::string(what) +
           (text.is_cut ? " is too long for the sheet: its end is left out."
                        : " is long: its letters are " + inDigits(text.height, 2) + " mm high.");
}

/// Text with the lower left corner at `corner`.
SheetLayer notes(const Vector2d& corner, double width, const std::string& note,
                 const std::string& title, std::vector<std::string>& remarks) {
    SheetLayer layer{"title", "Title", {}, {}};
    const FittedText below = fit(note, note_height, least_height, width, 1);
    addLines(below, corner, layer);
    if (below.is_cut) remarks.push_back(remarkOn("The note below the drawing", below));
    FittedText above = fit(title, title_height, height_of_two_lines, width, 1);
    if (above.is_cut) above = fit(title, height_of_two_lines, least_height, width, 2);
    addLines(above, corner - Vector2d(0, 1.6 * note_height), layer);
    if (above.height < title_height) remarks.push_back(remarkOn("The title", above));
    return layer;
}

bool showsSides(const std::vector<DrawnView>& views) {
    return std::count_if(views.begin(), views.end(),
                         [](const DrawnView& view) { return view.frame.side != Side::Other; }) > 1;
}

}  // namespace

std::string nameOf(const ViewFrame& frame, bool beside_scale) {
    return frame.eye && beside_scale ? frame.name + " (" + no_scale + ')' : frame.name;
}

double widthInAnyFont(const std::string& text, double height) {
    return widest_font * height * widthOf(text);
}

std::string elided(const std::string& text, double height, double width) {
    const std::u32string letters = lettersOf(text);
    if (fitting(letters, height, width) == letters.size()) return text;
    const double dots = widest_font * height * widthOf(U'\u2026');
    return inUtf8(letters.substr(0, fitting(letters, height, width - dots))) + "…";
}

SheetGroup drawFurniture(const std::vector<DrawnView>& views, const SheetLayout& layout,
                         const Eigen::Vector3d& object_size, const SheetOptions& options,
                         Sheet& sheet) {
    SheetGroup group{"sheet", "Sheet", {}};
    if (!options.has_furniture) return group;
    if (views.size() > 1) group.layers.push_back(viewNames(views, layout));
    const double bottom = layout.size.y() - sheet_margin;
    double right = layout.size.x() - sheet_margin;
    if (layout.scale > 0) {
        SheetLayer layer{"scale", "Scale", {}, {}};
        right = addScaleBar({right, bottom}, layout.scale, layer) - strip_gap;
        if (showsSides(views)) {
            right -= symbol_width;
            addProjectionSymbol({right, bottom}, options.arrangement, layer);
            right -= strip_gap;
        }
        group.layers.push_back(std::move(layer));
    }
    group.layers.push_back(notes({sheet_margin, bottom}, right - sheet_margin,
                                 noteOf(views, layout, object_size, options, sheet.kernel),
                                 options.title, sheet.remarks));
    return group;
}

}  // namespace line_drawing
