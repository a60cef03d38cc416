// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/make_sheet.h"

#include <QSet>
#include <algorithm>
#include <array>
#include <cmath>

#include "options/progress_part.h"
#include "options/words.h"
#include "sheet/sheet_furniture.h"
#include "sheet/view_drawing.h"
#include "sight/observer.h"
#include "views/joined_surface.h"

namespace line_drawing {
namespace {

using laplacian_lines::Progress;
using laplacian_lines::TriangleMesh;

constexpr double check_pixel = 0.25;  // mm on the sheet
// Of the work: what is done before the first view, for all sheets and for one.
constexpr double sight_share = 0.1, fields_share = 0.3;

void check(const SheetOptions& options) {
    if (options.views.empty() && options.sections.empty()) refuse("A drawing needs a view.");
    if (!(options.mm_per_unit > 0) || !std::isfinite(options.mm_per_unit))
        refuse("The unit of the mesh has to be a positive length.");
    if (!(options.tolerance >= 0.001 && options.tolerance <= 10))
        refuse("The tolerance of curves has to be between 0.001 and 10 mm.");
    if (!(options.shortest_line >= 0)) refuse("The shortest line has to be 0 mm or more.");
    for (const double pen : options.pens)
        if (!(pen > 0 && pen <= 10))
            refuse("The width of a pen has to be more than 0, up to 10 mm.");
}

constexpr std::array<double, 10> pen_series = {0.1, 0.13, 0.18, 0.25, 0.35, 0.5, 0.7, 1, 1.4, 2};
/// mm on paper: smaller drawings are drawn with pens one or two steps finer.
constexpr double full_size = 40, half_size = 28;

/// Pens of draughtsmen go in steps of √2, as do the sizes of drawings here.
double finer(double pen, int steps) {
    const auto place = std::lower_bound(pen_series.begin(), pen_series.end(), pen);
    return pen_series[std::size_t(std::max<std::ptrdiff_t>(0, place - pen_series.begin() - steps))];
}

SheetOptions withPensFor(const SheetLayout& layout, SheetOptions options) {
    double size = 0;
    for (const QRectF& place : layout.places)
        size = std::max({size, place.width(), place.height()});
    const int steps = size >= full_size ? 0 : size >= half_size ? 1 : 2;
    for (double& pen : options.pens)
        if (steps > 0 && pen <= pen_series.back()) pen = std::min(pen, finer(pen, steps));
    return options;
}

/// As their marks, if any view has these.
void nameSections(std::vector<DrawnView>& views) {
    const bool has_marks = std::any_of(views.begin(), views.end(),
                                       [](const DrawnView& view) { return !view.marks.empty(); });
    std::size_t number = 0;
    for (DrawnView& view : views)
        if (view.is_section && has_marks) {
            const QString letter = letterOf(number++);
            view.frame.name = letter + "–" + letter;
        }
}

/// The same view may have been asked for twice.
void tellApart(std::vector<SheetGroup>& groups) {
    QSet<QString> keys;
    for (SheetGroup& group : groups) {
        const QString key = group.key;
        for (int number = 2; keys.contains(group.key); ++number)
            group.key = QString("%1-%2").arg(key).arg(number);
        keys << group.key;
    }
}

QString remarkOn(const DrawnView& view, double missing) {
    return QString(
               "%1: %2 mm of the outline were missing and are drawn from the mesh's edges. "
               "Please report this with the mesh.")
        .arg(view.frame.name)
        .arg(missing, 0, 'f', 1);
}

QString remarkOn(const QString& note) {
    return QString(
               "Vessel: %1. So far does the rim go around the axis, and by so much does the "
               "vessel lean.")
        .arg(note);
}

std::vector<DrawnView> standAll(Observer& observer, const SheetOptions& options) {
    std::vector<DrawnView> views;
    for (const ViewFrame& frame : options.views)
        views.push_back(observer.stand(frame, options));
    for (const Section& section : options.sections)
        views.push_back(observer.cut(section, options));
    nameSections(views);
    return views;
}

Sheet drawSheet(Observer& observer, const SheetOptions& wanted, const Progress& progress) {
    std::vector<DrawnView> views = standAll(observer, wanted);
    const SheetLayout layout = layOut(views, wanted);  // before much work, since it may refuse
    SheetOptions options = withPensFor(layout, wanted);
    if (!options.views.empty()) {
        const double scale = layout.placements[0].scale;
        observer.makeReady(options, scale, part(progress, 0, fields_share));
        options.kernel = {observer.kernelSize() * options.mm_per_unit * scale, false};
    }
    const auto share = [&](std::size_t views_done) {
        const double all = std::max<double>(1, double(options.views.size()));
        return 1 - (1 - fields_share) * (1 - double(views_done) / all);
    };
    Sheet sheet{layout.size,
                options.title,
                {},
                layout.scale,
                options.views.empty() ? 0 : options.kernel.size};
    for (std::size_t i = 0; i < options.views.size(); ++i) {  // sections have their lines
        observer.look(views[i], options, part(progress, share(i), share(i + 1)));
        const double missing =
            observer.checkOutlines(views[i], options, check_pixel / layout.placements[i].scale);
        if (missing > 0) sheet.remarks << remarkOn(views[i], missing);
        if (!views[i].note.isEmpty()) sheet.remarks << remarkOn(views[i].note);
    }
    for (std::size_t i = 0; i < views.size(); ++i)
        sheet.groups.push_back(
            drawView(views[i], i + 1, layout.placements[i], layout.places[i], options));
    tellApart(sheet.groups);
    SheetGroup furniture =
        drawFurniture(views, layout, options.mm_per_unit * observer.objectSize(), options);
    if (!furniture.layers.empty()) sheet.groups.push_back(std::move(furniture));
    return sheet;
}

}  // namespace

std::vector<Sheet> makeSheets(const Objects& objects, const std::vector<SheetOptions>& options,
                              const Progress& progress) {
    if (objects.empty()) refuse("A drawing needs an object.");
    for (const SheetOptions& o : options)
        check(o);
    std::vector<SheetOptions> plain = options;
    for (SheetOptions& o : plain) {
        o.title = oneLine(o.title);
        o.source = oneLine(o.source);
    }
    Observer observer(objects, part(progress, 0, sight_share));
    const double share = (1 - sight_share) / std::max<double>(1, double(options.size()));
    std::vector<Sheet> sheets;
    for (const SheetOptions& o : plain) {
        const double begin = sight_share + share * double(sheets.size());
        const bool is_last = sheets.size() + 1 == options.size();
        sheets.push_back(
            drawSheet(observer, o, part(progress, begin, is_last ? 1 : begin + share)));
    }
    return sheets;
}

SheetPlan planSheet(const Objects& objects, const SheetOptions& options) {
    check(options);
    const JoinedSurface surface(objects);
    const Eigen::AlignedBox3d bounds = boundsOf(surface.mesh());
    if (bounds.isEmpty()) refuse("There is nothing to draw: the mesh has no triangles.");
    std::vector<DrawnView> views;
    for (const ViewFrame& frame : options.views)
        views.push_back(standBefore(surface.mesh(), bounds, frame, options));
    for (const Section& section : options.sections)
        views.push_back(standBefore(surface.mesh(), bounds, section, options));
    const SheetLayout layout = layOut(views, options);
    return {layout.size, layout.scale};
}

Sheet makeSheet(const TriangleMesh& mesh, const laplacian_lines::Field& field,
                const SheetOptions& options, const Progress& progress) {
    return makeSheets({{mesh, &field}}, {options}, progress).front();
}

}  // namespace line_drawing
