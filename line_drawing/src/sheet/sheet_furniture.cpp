// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_furniture.h"

#include <QRectF>
#include <algorithm>
#include <cmath>

#include "sections/section_marks.h"

namespace line_drawing {
namespace {

// mm
constexpr double thin_pen = 0.18;
constexpr double title_height = 4, note_height = 2.6, longest_bar = 50, bar_height = 1.2;
constexpr double symbol_height = 5, symbol_width = 14, strip_gap = 6;
constexpr double letter_width = 0.6;  // of a font's height, on average
const char* const no_scale = "perspective, not to scale";

SheetPath filled(const QRectF& rectangle) {
    SheetPath result;
    result.path.addRect(rectangle);
    return result;
}

SheetPath drawn(const QPainterPath& path) {
    return {path, thin_pen};
}

QString inMillimetres(double x) {
    if (x < 0.1) return QString::number(x, 'g', 3);
    return QString::number(x, 'f', x < 10 ? 2 : x < 1000 ? 1 : 0);
}

QString nameOf(const ViewFrame& frame, bool beside_scale) {
    return frame.eye && beside_scale ? QString("%1 (%2)").arg(frame.name, no_scale) : frame.name;
}

SheetLayer viewNames(const std::vector<DrawnView>& views, const SheetLayout& layout) {
    SheetLayer layer{"names", "Names of views", {}, {}};
    for (std::size_t i = 0; i < views.size(); ++i) {
        const QRectF& place = layout.places[i];
        layer.texts.push_back({{place.center().x(),
                                place.bottom() + roomOfMarks(views[i]).y() + 2 * view_name_height},
                               view_name_height,
                               Qt::AlignHCenter,
                               nameOf(views[i].frame, layout.scale > 0)});
    }
    return layer;
}

/// Blocks of a tenth, fifth or quarter of the bar, black and white in turn.
int partsOf(double length) {
    const double first = length / std::pow(10, std::floor(std::log10(length) + 1e-9));
    return first > 1.5 && first < 3 ? 4 : 5;
}

/// With its lower right corner at `corner`. Returns its left end.
double addScaleBar(const QPointF& corner, double scale, SheetLayer& layer) {
    const double length = barLength(scale, longest_bar), width = length * scale;
    const int parts = partsOf(length);
    const double left = corner.x() - width, top = corner.y() - bar_height;
    QPainterPath frame;
    frame.addRect({left, top, width, bar_height});
    layer.paths.push_back(drawn(frame));
    for (int part = 0; part < parts; part += 2)
        layer.paths.push_back(
            filled({left + width * part / parts, top, width / parts, bar_height}));
    const double base = top - 1;
    layer.texts.push_back({{left, base}, note_height, Qt::AlignLeft, "0"});
    layer.texts.push_back({{corner.x(), base}, note_height, Qt::AlignRight, lengthInWords(length)});
    return left;
}

/// A truncated cone and what is seen from its small end, which lies on the left: on the right of
/// it in first angle, on the left in third angle (ISO 5456-2).
void addProjectionSymbol(const QPointF& corner, Arrangement arrangement, SheetLayer& layer) {
    const double h = symbol_height, y = corner.y() - h / 2;
    const bool is_first = arrangement == Arrangement::FirstAngle;
    const double cone = is_first ? corner.x() : corner.x() + symbol_width - h * 1.2;
    const double circles = is_first ? corner.x() + symbol_width - h / 2 : corner.x() + h / 2;
    QPainterPath trapezium;
    trapezium.moveTo(cone, y - h / 4);
    trapezium.lineTo(cone + 1.2 * h, y - h / 2);
    trapezium.lineTo(cone + 1.2 * h, y + h / 2);
    trapezium.lineTo(cone, y + h / 4);
    trapezium.closeSubpath();
    layer.paths.push_back(drawn(trapezium));
    for (const double radius : {h / 4, h / 2}) {
        QPainterPath circle;
        circle.addEllipse(QPointF(circles, y), radius, radius);
        layer.paths.push_back(drawn(circle));
    }
}

QString elided(const QString& text, double height, double width) {
    const auto letters = int(width / (letter_width * height));
    if (text.size() <= letters) return text;
    QString begin = text.left(std::max(0, letters - 1));
    if (!begin.isEmpty() && begin.at(begin.size() - 1).isHighSurrogate())
        begin.chop(1);  // half a letter
    return begin + "…";
}

QString noteOf(const std::vector<DrawnView>& views, const SheetLayout& layout,
               const Eigen::Vector3d& size, const SheetOptions& options) {
    QStringList parts = {layout.scale > 0 ? scaleInWords(layout.scale) : no_scale,
                         sizeInWords(size)};
    if (options.kernel.size > 0) parts << QString("√h %1 mm").arg(options.kernel.size, 0, 'g', 2);
    for (const DrawnView& view : views)
        if (!view.note.isEmpty()) parts << view.note;
    if (!options.source.isEmpty()) parts << options.source;
    return parts.join(" · ");
}

/// Lines of text with the lower left corner at `corner`.
SheetLayer notes(const QPointF& corner, double width, const QString& note, const QString& title) {
    SheetLayer layer{"title", "Title", {}, {}};
    layer.texts.push_back({corner, note_height, Qt::AlignLeft, elided(note, note_height, width)});
    if (!title.isEmpty())
        layer.texts.push_back({corner - QPointF(0, 1.6 * note_height), title_height, Qt::AlignLeft,
                               elided(title, title_height, width)});
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

QString sizeInWords(const Eigen::Vector3d& size) {
    return QString("%1 × %2 × %3 mm")
        .arg(inMillimetres(size.x()), inMillimetres(size.y()), inMillimetres(size.z()));
}

QString lengthInWords(double mm) {
    if (mm >= 1000) return QString("%1 m").arg(mm / 1000);
    if (mm >= 10) return QString("%1 cm").arg(mm / 10);
    return QString("%1 mm").arg(mm);
}

SheetGroup drawFurniture(const std::vector<DrawnView>& views, const SheetLayout& layout,
                         const Eigen::Vector3d& object_size, const SheetOptions& options) {
    SheetGroup group{"sheet", "Sheet", {}};
    if (options.has_view_names && views.size() > 1)
        group.layers.push_back(viewNames(views, layout));
    const double bottom = layout.size.height() - sheet_margin;
    double right = layout.size.width() - sheet_margin;
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
