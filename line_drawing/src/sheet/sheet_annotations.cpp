// SPDX-License-Identifier: GPL-3.0-or-later
// What stands around the views: their names, and in a strip at the bottom the title and notes on
// the left, the projection symbol and the scale bar on the right. Long texts are first set smaller.
#include "sheet/sheet_annotations.h"

#include <algorithm>
#include <cmath>

#include "line_drawing/words.h"
#include "planes/lettering.h"
#include "sections/section_marks.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

// mm
constexpr double kThinPen = 0.18;
constexpr double kNoteHeight = 2.6, kLongestBar = 50, kBarHeight = 1.2;
constexpr double kLeastHeight = 1.8, kSmaller = 0.94;           // of letters; factor of a step
constexpr double kHeightOfTwoLines = 3.2, kLineDistance = 1.3;  // of a title; of its height
constexpr double kWidestFont = 1.15;                            // of our letters' width
constexpr double kSymbolHeight = 5, kSymbolWidth = 14, kStripGap = 6, kShortNote = 40;
constexpr double kTitleAbove = 1.6;  // the note, in heights of its letters
const char* const kNoScale = "perspective, not to scale";

/// Filled if `pen` is 0.
SheetPath rectangle(const Vector2d& corner, double width, double height, double pen = 0) {
    SheetPath result{{}, pen};
    result.path.add_rectangle(corner, width, height);
    return result;
}

/// How many letters fit.
std::size_t fitting(std::u32string_view letters, double height, double width) {
    std::size_t count = 0;
    for (; count < letters.size(); ++count) {
        width -= kWidestFont * height * width_of(letters[count]);
        if (width < 0) break;
    }
    return count;
}

struct FittedText {
    double height;
    std::vector<std::u32string> lines;
    bool is_cut = false;
};

/// Breaks lines between words if possible, and leaves out what `most_lines` do not hold.
FittedText wrapped(std::u32string_view rest, double height, double width, std::size_t most_lines) {
    FittedText text{height, {}};
    while (!rest.empty() && text.lines.size() < most_lines) {
        std::size_t count = std::max<std::size_t>(fitting(rest, height, width), 1);
        const std::size_t space = rest.substr(0, count + 1).rfind(U' ');
        if (count < rest.size() && space != rest.npos && space > 0) count = space;
        text.lines.emplace_back(rest.substr(0, count));
        rest.remove_prefix(count);
        rest.remove_prefix(std::min(rest.find_first_not_of(U' '), rest.size()));
    }
    text.is_cut = !rest.empty();
    return text;
}

/// Wraps text in letters of `height`, or smaller ones, down to `least`, until it fits; if it never
/// does, the last line ends with "…".
FittedText fit(const std::string& text, double height, double least, double width,
               std::size_t most_lines) {
    const std::u32string letters = letters_of(text);
    FittedText fitted = wrapped(letters, height, width, most_lines);
    while (fitted.is_cut && height > least) {
        height = std::max(least, height * kSmaller);
        fitted = wrapped(letters, height, width, most_lines);
    }
    if (!fitted.is_cut) return fitted;
    fitted.lines.back() =
        letters_of(elided(in_utf8(fitted.lines.back() + U" \u2026"), fitted.height, width));
    return fitted;
}

SheetLayer view_names(const std::vector<DrawnView>& views, const SheetLayout& layout) {
    SheetLayer layer{"names", "Names of views", {}, {}};
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Eigen::AlignedBox2d& place = layout.placements[i].on_sheet(views[i].bounds);
        layer.texts.push_back(
            {{place.center().x(), place.max().y() + room_of_marks(views[i]).y() + kViewNameRow},
             kViewNameHeight,
             TextAnchor::Middle,
             name_of(views[i].frame, layout.scale > 0)});
    }
    return layer;
}

/// The longest bar of 1, 2 or 5 times a power of ten, in mm of the object, that is drawn at most
/// `most` long.
double bar_length(double scale, double most) {
    double power = std::pow(10, std::floor(std::log10(most / scale) + 1e-9));
    for (const double first : {5., 2.})
        if (first * power * scale <= most * (1 + 1e-9)) return first * power;
    return power;
}

/// "5 cm" for 50.
std::string length_text(double mm) {
    if (mm >= 1e6) return in_digits(mm / 1e6) + " km";
    if (mm >= 1000) return in_digits(mm / 1000) + " m";
    if (mm >= 10) return in_digits(mm / 10) + " cm";
    return mm < 0.1 ? in_digits(mm * 1000) + " µm" : in_digits(mm) + " mm";
}

/// Number of blocks of the bar, alternately black and white.
int parts_of(double length) {
    const double first = length / std::pow(10, std::floor(std::log10(length) + 1e-9));
    return first > 1.5 && first < 3 ? 4 : 5;
}

/// Lower right corner at `corner`. Returns the left end.
double add_scale_bar(const Vector2d& corner, double scale, SheetLayer& layer) {
    const double length = bar_length(scale, kLongestBar), width = length * scale;
    const int parts = parts_of(length);
    const double left = corner.x() - width, top = corner.y() - kBarHeight;
    layer.paths.push_back(rectangle({left, top}, width, kBarHeight, kThinPen));
    for (int part = 0; part < parts; part += 2)
        layer.paths.push_back(
            rectangle({left + width * part / parts, top}, width / parts, kBarHeight));
    const double base = top - 1;
    layer.texts.push_back({{left, base}, kNoteHeight, TextAnchor::Left, "0"});
    layer.texts.push_back(
        {{corner.x(), base}, kNoteHeight, TextAnchor::Right, length_text(length)});
    return left;
}

/// A truncated cone with the view from its small end, on its left: on the right in first angle, on
/// the left in third (ISO 5456-2). Lower left corner at `corner`.
void add_projection_symbol(const Vector2d& corner, Arrangement arrangement, SheetLayer& layer) {
    const double h = kSymbolHeight, y = corner.y() - h / 2;
    const bool is_first = arrangement == Arrangement::FirstAngle;
    const double cone = is_first ? corner.x() : corner.x() + kSymbolWidth - h * 1.2;
    const double circles = is_first ? corner.x() + kSymbolWidth - h / 2 : corner.x() + h / 2;
    Path trapezium;
    trapezium.add_polygon({{cone, y - h / 4},
                           {cone + 1.2 * h, y - h / 2},
                           {cone + 1.2 * h, y + h / 2},
                           {cone, y + h / 4}});
    layer.paths.push_back({trapezium, kThinPen});
    for (const double radius : {h / 4, h / 2}) {
        Path circle;
        circle.add_circle({circles, y}, radius);
        layer.paths.push_back({circle, kThinPen});
    }
}

std::string note_of(const std::vector<DrawnView>& views, const SheetLayout& layout,
                    const Eigen::Vector3d& size, const SheetOptions& options, double kernel) {
    Words parts = {layout.scale > 0 ? scale_text(layout.scale) : kNoScale, size_text(size)};
    if (kernel > 0) parts.push_back("√h " + kernel_text(kernel) + " mm");
    for (const DrawnView& view : views)
        if (!view.note.empty()) parts.push_back(view.note);
    if (!options.source.empty()) parts.push_back(options.source);
    return joined(parts, " · ");
}

/// Adds lines of text from below, the last one with its left end at `corner`.
void add_lines(const FittedText& text, const Vector2d& corner, SheetLayer& layer) {
    double base = corner.y();
    for (std::size_t i = text.lines.size(); i-- > 0; base -= kLineDistance * text.height)
        layer.texts.push_back(
            {{corner.x(), base}, text.height, TextAnchor::Left, in_utf8(text.lines[i])});
}

std::string remark_on(const char* what, const FittedText& text) {
    return std::string(what) +
           (text.is_cut ? " is too long for the sheet: its end is left out."
                        : " is long: its letters are " + in_digits(text.height, 2) + " mm high.");
}

/// Text with the lower left corner at `corner`.
SheetLayer notes(const Vector2d& corner, double width, const std::string& note,
                 const std::string& title, std::vector<std::string>& remarks) {
    SheetLayer layer{"title", "Title", {}, {}};
    const FittedText below = fit(note, kNoteHeight, kLeastHeight, width, 1);
    add_lines(below, corner, layer);
    if (below.is_cut) remarks.push_back(remark_on("The note below the drawing", below));
    add_title(title, corner - Vector2d(0, kTitleAbove * kNoteHeight), width, layer, remarks);
    return layer;
}

bool shows_sides(const std::vector<DrawnView>& views) {
    return std::count_if(views.begin(), views.end(),
                         [](const DrawnView& view) { return view.frame.side != Side::Other; }) > 1;
}

}  // namespace

bool have_names(const std::vector<DrawnView>& views, const SheetOptions& options) {
    return options.has_annotations && views.size() > 1;
}

std::string name_of(const ViewFrame& frame, bool sheet_has_scale) {
    return frame.eye && sheet_has_scale ? frame.name + " (" + kNoScale + ')' : frame.name;
}

double least_strip_width(const std::vector<DrawnView>& views, const SheetOptions& options) {
    if (!options.has_annotations) return 0;
    const double symbol = shows_sides(views) ? kSymbolWidth + kStripGap : 0;
    return kShortNote + kStripGap + symbol + kLongestBar;
}

double width_in_any_font(const std::string& text, double height) {
    return kWidestFont * height * width_of(text);
}

std::string elided(const std::string& text, double height, double width) {
    const std::u32string letters = letters_of(text);
    if (fitting(letters, height, width) == letters.size()) return text;
    const double dots = kWidestFont * height * width_of(U'\u2026');
    return in_utf8(letters.substr(0, fitting(letters, height, width - dots))) + "…";
}

void add_title(const std::string& title, const Vector2d& corner, double width, SheetLayer& layer,
               std::vector<std::string>& remarks) {
    FittedText fitted = fit(title, kTitleHeight, kHeightOfTwoLines, width, 1);
    if (fitted.is_cut) fitted = fit(title, kHeightOfTwoLines, kLeastHeight, width, 2);
    add_lines(fitted, corner, layer);
    if (fitted.height < kTitleHeight) remarks.push_back(remark_on("The title", fitted));
}

SheetGroup draw_annotations(const std::vector<DrawnView>& views, const SheetLayout& layout,
                            const Eigen::Vector3d& object_size, double kernel,
                            const SheetOptions& options, std::vector<std::string>& remarks) {
    SheetGroup group{"sheet", "Sheet", {}};
    if (!options.has_annotations) return group;
    if (have_names(views, options)) group.layers.push_back(view_names(views, layout));
    const double bottom = layout.size.y() - kSheetMargin;
    double right = layout.size.x() - kSheetMargin;
    if (layout.scale > 0) {
        SheetLayer layer{"scale", "Scale", {}, {}};
        right = add_scale_bar({right, bottom}, layout.scale, layer) - kStripGap;
        if (shows_sides(views)) {
            right -= kSymbolWidth;
            add_projection_symbol({right, bottom}, options.arrangement, layer);
            right -= kStripGap;
        }
        group.layers.push_back(std::move(layer));
    }
    group.layers.push_back(notes({kSheetMargin, bottom}, right - kSheetMargin,
                                 note_of(views, layout, object_size, options, kernel),
                                 options.title, remarks));
    return group;
}

}  // namespace line_drawing
