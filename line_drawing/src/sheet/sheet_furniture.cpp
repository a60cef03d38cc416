// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_layout.h"

#include <algorithm>
#include <cmath>

#include "line_drawing/words.h"
#include "sections/section_marks.h"

namespace line_drawing {
namespace {

using Eigen::Vector2d;

// mm
constexpr double thin_pen = 0.18;
constexpr double title_height = 4, note_height = 2.6, longest_bar = 50, bar_height = 1.2;
constexpr double symbol_height = 5, symbol_width = 14, strip_gap = 6;
const char* const no_scale = "perspective, not to scale";

/// Filled, or with this pen.
SheetPath rectangle(const Vector2d& corner, double width, double height, double pen = 0) {
    SheetPath result{{}, pen};
    result.path.addRectangle(corner, width, height);
    return result;
}

std::string inMillimetres(double x) {
    if (x < 0.1) return inDigits(x, 3);
    return inDecimals(x, x < 10 ? 2 : x < 1000 ? 1 : 0);
}

std::string nameOf(const ViewFrame& frame, bool beside_scale) {
    return frame.eye && beside_scale ? frame.name + " (" + no_scale + ')' : frame.name;
}

SheetLayer viewNames(const std::vector<DrawnView>& views, const SheetLayout& layout) {
    SheetLayer layer{"names", "Names of views", {}, {}};
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Eigen::AlignedBox2d& place = layout.places[i];
        layer.texts.push_back({{place.center().x(),
                                place.max().y() + roomOfMarks(views[i]).y() + 2 * view_name_height},
                               view_name_height,
                               TextAnchor::Middle,
                               nameOf(views[i].frame, layout.scale > 0)});
    }
    return layer;
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
                   const Eigen::Vector3d& size, const SheetOptions& options) {
    Words parts = {layout.scale > 0 ? scaleInWords(layout.scale) : no_scale, sizeInWords(size)};
    if (options.kernel.size > 0) parts.push_back("√h " + inDigits(options.kernel.size, 2) + " mm");
    for (const DrawnView& view : views)
        if (!view.note.empty()) parts.push_back(view.note);
    if (!options.source.empty()) parts.push_back(options.source);
    return joined(parts, " · ");
}

/// Text with the lower left corner at `corner`.
SheetLayer notes(const Vector2d& corner, double width, const std::string& note,
                 const std::string& title) {
    SheetLayer layer{"title", "Title", {}, {}};
    layer.texts.push_back(
        {corner, note_height, TextAnchor::Left, elided(note, note_height, width)});
    if (!title.empty())
        layer.texts.push_back({corner - Vector2d(0, 1.6 * note_height), title_height,
                               TextAnchor::Left, elided(title, title_height, width)});
    return layer;
}

bool showsSides(const std::vector<DrawnView>& views) {
    return std::count_if(views.begin(), views.end(),
                         [](const DrawnView& view) { return view.frame.side != Side::Other; }) > 1;
}

}  // namespace

double barLength(double scale, double most) {
    double power = std::pow(10, std::floor(std::log10(most / scale) + 1e-9));
    for (const double first : {5., 2.})
        if (first * power * scale <= most) return first * power;
    return power;
}

std::string sizeInWords(const Eigen::Vector3d& size) {
    return inMillimetres(size.x()) + " × " + inMillimetres(size.y()) + " × " +
           inMillimetres(size.z()) + " mm";
}

std::string elided(const std::string& text, double height, double width) {
    constexpr double letter_width = 0.6;  // of a font's height, on average
    const std::u32string letters = lettersOf(text);
    const auto most = std::size_t(std::max(1., width / (letter_width * height)));
    return letters.size() <= most ? text : inUtf8(letters.substr(0, most - 1)) + "…";
}

std::string lengthInWords(double mm) {
    if (mm >= 1000) return inDigits(mm / 1000) + " m";
    if (mm >= 10) return inDigits(mm / 10) + " cm";
    return inDigits(mm) + " mm";
}

SheetGroup drawFurniture(const std::vector<DrawnView>& views, const SheetLayout& layout,
                         const Eigen::Vector3d& object_size, const SheetOptions& options) {
    SheetGroup group{"sheet", "Sheet", {}};
    if (options.has_view_names && views.size() > 1)
        group.layers.push_back(viewNames(views, layout));
    const double bottom = layout.size.y() - sheet_margin;
    double right = layout.size.x() - sheet_margin;
    if (options.has_scale_bar && layout.scale > 0) {
        SheetLayer layer{"scale", "Scale", {}, {}};
        right = addScaleBar({right, bottom}, layout.scale, layer) - strip_gap;
        if (showsSides(views)) {
            right -= symbol_width;
            addProjectionSymbol({right, bottom}, options.arrangement, layer);
            right -= strip_gap;
        }
        group.layers.push_back(std::move(layer));
    }
    if (options.has_notes)
        group.layers.push_back(notes({sheet_margin, bottom}, right - sheet_margin,
                                     noteOf(views, layout, object_size, options), options.title));
    return group;
}

}  // namespace line_drawing
