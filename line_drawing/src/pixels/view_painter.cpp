// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/view_painter.h"

#include <algorithm>
#include <iterator>

#include "options/paper_and_pens.h"
#include "pixels/painting.h"
#include "sheet/view_drawing.h"
#include "sight/object_lines.h"
#include "sight/view_builder.h"

namespace line_drawing {
namespace {

using laplacian_lines::part;
using laplacian_lines::Progress;
using laplacian_lines::report;

// Progress at which visibility, and the lines within faces, are prepared.
constexpr double kSightShare = 0.3, kLinesShare = 0.7;
// mm: twice 24 inner pens of .25 mm, the largest constant of strokes/. Lengths that grow with the
// picture, a share of it and the kernel, may be more.
constexpr double kRoomAround = 12;
constexpr std::size_t kMostKeptBytes = std::size_t(128) << 20;  // of extractors for other kernels

/// In pixels, x right, y down.
Eigen::Vector2d pixel_of(const Eigen::Vector3d& point, const WindowView& view) {
    const Eigen::Vector4d clip = view.to_clip * point.homogeneous();
    const Eigen::Vector2d place = clip.head<2>() / clip.w();
    return (Eigen::Vector2d(1 + place.x(), 1 - place.y()) / 2)
        .cwiseProduct(view.size.cast<double>());
}

/// The placement of a view on a sheet whose upper left corner is that of the window, from the
/// point before the eye, or the middle of a parallel view, and one right of it.
Placement placement_of(const WindowView& view, const Eigen::Vector3d& middle, double mm_per_unit,
                       double reach) {
    const Eigen::Vector3d seen =
        view.frame.eye ? Eigen::Vector3d(*view.frame.eye - reach * view.frame.towards_viewer)
                       : middle;
    const Eigen::Vector3d beside = seen + reach * view.frame.right;
    const Projection projection(view.frame, middle);
    const Eigen::Vector2d a = projection(seen) * mm_per_unit, b = projection(beside) * mm_per_unit;
    const Eigen::Vector2d on_paper = pixel_of(seen, view) / view.pixels_per_mm;
    const double scale =
        (pixel_of(beside, view).x() / view.pixels_per_mm - on_paper.x()) / (b.x() - a.x());
    return {scale, on_paper - scale * Eigen::Vector2d(a.x(), -a.y())};
}

/// Whether a line reaches the window, or is so near that lines in the window may join it.
bool is_near(const DrawnLine& line, const Placement& placement, const WindowView& window) {
    const Eigen::Vector2d size = window.size.cast<double>() / window.pixels_per_mm,
                          room = Eigen::Vector2d::Constant(kRoomAround);
    return Eigen::AlignedBox2d(-room, size + room).intersects(placement.on_sheet(box_of(line)));
}

bool is_of(const DrawnLine& line, const Ink& ink, bool hidden_apart) {
    const bool is_apart = hidden_apart && line.line_class == LineClass::Hidden;
    return ink.kinds[line.kind] && is_apart == ink.is_hidden;
}

std::vector<std::uint8_t> paint_ink(const DrawnView& drawn, const Placement& placement,
                                    const SheetOptions& options, const WindowView& window,
                                    bool is_hidden, const Progress& progress) {
    report(progress, 1, "Drawing");
    std::vector<SheetGroup> groups;
    groups.push_back(draw_view(drawn, 1, placement, options));
    if (is_hidden)
        for (SheetLayer& layer : groups.front().layers)
            for (SheetPath& path : layer.paths)
                path.dash = 0;
    report(progress, 1, "Painting");
    return paint_groups(groups, window.size, window.pixels_per_mm).grays();
}

}  // namespace

struct ViewPainter::Data {
    explicit Data(Objects all)
        : objects(std::move(all)), builder(objects), lines(objects, kMostKeptBytes) {}

    const Objects objects;
    ViewBuilder builder;
    ObjectLines lines;
    bool is_ready = false;  ///< visibility is prepared
};

ViewPainter::ViewPainter(Objects objects) : data_(std::make_unique<Data>(std::move(objects))) {}

ViewPainter::~ViewPainter() = default;

void ViewPainter::prepare(const Progress& progress) {
    if (!data_->is_ready) data_->builder.prepare({{}}, progress);
    data_->is_ready = true;
}

PaintedView ViewPainter::paint(const WindowView& view, SheetOptions options,
                               const std::vector<Ink>& inks, bool may_wait,
                               const Progress& progress) {
    ViewBuilder& builder = data_->builder;
    prepare(part(progress, 0, kSightShare));
    DrawnView drawn = builder.empty_view(view.frame, options);
    const Placement placement =
        placement_of(view, builder.middle(), options.mm_per_unit, builder.object_size().norm());
    options.pens = pens_for(placement.on_sheet(drawn.bounds).sizes().maxCoeff(), options.pens);
    PaintedView painted{view.size};
    painted.is_final =
        data_->lines.prepare(options, placement.scale, may_wait ? Kernel::Exact : Kernel::Nearest,
                             part(progress, kSightShare, kLinesShare));
    options.kernel = {data_->lines.kernel_size() * options.mm_per_unit * placement.scale, false};
    report(progress, kLinesShare, "Finding lines");
    const auto lines = data_->lines.extract(builder.view_of(drawn, options), options.style);
    builder.add_lines(drawn, lines, options, part(progress, kLinesShare, 1));
    std::vector<DrawnLine> all;
    for (DrawnLine& line : drawn.lines)
        if (is_near(line, placement, view)) all.push_back(std::move(line));
    const bool hidden_apart =
        std::any_of(inks.begin(), inks.end(), [](const Ink& ink) { return ink.is_hidden; });
    for (const Ink& ink : inks) {
        drawn.lines.clear();
        std::copy_if(all.begin(), all.end(), std::back_inserter(drawn.lines),
                     [&](const DrawnLine& line) { return is_of(line, ink, hidden_apart); });
        painted.inks.push_back(paint_ink(drawn, placement, options, view, ink.is_hidden, progress));
    }
    return painted;
}

}  // namespace line_drawing
