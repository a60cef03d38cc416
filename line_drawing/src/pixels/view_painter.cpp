// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/view_painter.h"

#include "options/progress_part.h"
#include "pixels/painting.h"
#include "sheet/sheet_layout.h"
#include "sight/object_lines.h"
#include "sight/observer.h"

namespace line_drawing {
namespace {

using laplacian_lines::Progress;

// Progress at which what hides lines and the lines within faces are ready.
constexpr double sight_share = 0.3, lines_share = 0.7;

/// In pixels, x right, y down.
Eigen::Vector2d pixelOf(const Eigen::Vector3d& point, const WindowView& view) {
    const Eigen::Vector4d clip = view.to_clip * point.homogeneous();
    const Eigen::Vector2d place = clip.head<2>() / clip.w();
    return (Eigen::Vector2d(1 + place.x(), 1 - place.y()) / 2)
        .cwiseProduct(view.size.cast<double>());
}

/// Of the view's picture on paper, whose upper left corner is that of the window: by a point in
/// sight and one right of it.
Placement placementOf(const WindowView& view, const Eigen::Vector3d& middle, double mm_per_unit,
                      double reach) {
    const Eigen::Vector3d seen =
        view.frame.eye ? Eigen::Vector3d(*view.frame.eye - reach * view.frame.towards_viewer)
                       : middle;
    const Eigen::Vector3d beside = seen + reach * view.frame.right;
    const Projection projection(view.frame, middle);
    const Eigen::Vector2d a = projection(seen) * mm_per_unit, b = projection(beside) * mm_per_unit;
    const Eigen::Vector2d on_paper = pixelOf(seen, view) / view.pixels_per_mm;
    const double scale =
        (pixelOf(beside, view).x() / view.pixels_per_mm - on_paper.x()) / (b.x() - a.x());
    return {scale, on_paper - scale * Eigen::Vector2d(a.x(), -a.y())};
}

}  // namespace

struct ViewPainter::Data {
    explicit Data(Objects all) : objects(std::move(all)), observer(objects), lines(objects) {}

    const Objects objects;
    Observer observer;
    ObjectLines lines;
    bool is_ready = false;  ///< what hides lines
};

ViewPainter::ViewPainter(Objects objects) : data_(std::make_unique<Data>(std::move(objects))) {}

ViewPainter::~ViewPainter() = default;

GrayPicture ViewPainter::paint(const WindowView& view, SheetOptions options,
                               const Progress& progress) {
    Observer& observer = data_->observer;
    if (!data_->is_ready) observer.prepare({options}, part(progress, 0, sight_share));
    data_->is_ready = true;
    DrawnView drawn = observer.stand(view.frame, options);
    const Placement placement =
        placementOf(view, observer.middle(), options.mm_per_unit, observer.objectSize().norm());
    options.pens = pensFor(placement.onSheet(drawn.bounds).sizes().maxCoeff(), options.pens);
    data_->lines.makeReady(options, placement.scale, part(progress, sight_share, lines_share));
    options.kernel = {data_->lines.kernelSize() * options.mm_per_unit * placement.scale, false};
    const auto lines = data_->lines.extract(observer.viewOf(drawn, options), options.style);
    observer.look(drawn, lines, options, part(progress, lines_share, 1));
    Canvas canvas =
        paintGroups({drawView(drawn, 1, placement, options)}, view.size, view.pixels_per_mm);
    return {view.size, std::move(canvas).grays()};
}

}  // namespace line_drawing
