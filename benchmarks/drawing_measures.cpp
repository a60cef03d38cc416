// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_measures.h"

#include <algorithm>

#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"

namespace benchmarks {

using namespace laplacian_lines;

namespace {

PixelMask surface_of(const DepthPicture& picture) {
    PixelMask mask(picture.size());
    for (int y = 0; y < picture.size(); ++y)
        for (int x = 0; x < picture.size(); ++x)
            if (picture.is_surface(x, y)) mask.set(x, y);
    return mask;
}

void add(PixelMask& mask, const PixelMask& others) {
    others.for_each([&](int x, int y) { mask.set(x, y); });
}

/// What is prepared once for all views of a mesh.
class MeasuredMesh {
public:
    MeasuredMesh(const TriangleMesh& mesh, const MeasureOptions& options)
        : options_(options),
          usable_(without_unusable(mesh)),
          field_(precompute(mesh)),
          extractor_(mesh, field_),
          edges_(sharp_edges(usable_, options.edge_angle)) {}

    std::vector<View> views() const { return views_around(usable_, options_.views); }

    /// Notes the drawing if its outline is less complete than that of `worst`.
    ViewMeasures measure(const View& view, double& least, std::vector<DrawnView>& worst) {
        const PictureCamera camera(view, usable_, options_.size);
        const DepthPicture surface(camera, usable_);
        extractor_.extract(view, options_.style, scratch_, lines_);
        const double d = field_.scale.diagonal;
        const PixelMask lines =
            line_pixels_in_sight(camera, surface, lines_, d, sight_edge(field_));
        const PixelMask outline = surface.outline();
        const PixelMask edges = edge_pixels(camera, surface, edges_, kSightClearance * d);
        const ViewMeasures result{drawn(outline, lines), strays(surface, lines, d),
                                  drawn(edges, lines), camera.is_perspective()};
        if (result.outline.is_known() && result.outline.value() < least) {
            least = result.outline.value();
            worst.assign(1, {surface_of(surface), outline, lines});
        }
        return result;
    }

private:
    const MeasureOptions& options_;
    const TriangleMesh usable_;
    const Field field_;
    const LineExtractor extractor_;
    const std::vector<EdgeEnds> edges_;
    ExtractionScratch scratch_;
    LineSet lines_;
};

}  // namespace

Share drawn(const PixelMask& wanted, const PixelMask& lines) {
    return wanted.share_in(lines.grown(kReach));
}

Share strays(const DepthPicture& surface, const PixelMask& lines, double diagonal) {
    PixelMask places = surface.outline();
    add(places, surface.depth_jumps(kDepthJump * diagonal));
    add(places, surface.normal_jumps(kNormalJump));
    Share share = lines.share_in(places.grown(kReach));
    share.found = share.all - share.found;
    return share;
}

MeshMeasures measure_drawing(const TriangleMesh& mesh, const MeasureOptions& options) {
    MeshMeasures result{mesh.triangles.size(), {}, {}};
    MeasuredMesh measured(mesh, options);
    double least = 2;
    for (const View& view : measured.views())
        result.views.push_back(measured.measure(view, least, result.worst_drawing));
    return result;
}

Spread spread(const MeshMeasures& mesh, Share ViewMeasures::*share) {
    Spread result;
    int known = 0;
    for (std::size_t i = 0; i < mesh.views.size(); ++i) {
        const Share& s = mesh.views[i].*share;
        if (!s.is_known()) continue;
        const double value = s.value();
        result.mean += value;
        if (!known++ || value < result.least) {
            result.least = value;
            result.least_view = int(i);
        }
        result.most = std::max(result.most, value);
    }
    if (known) result.mean /= known;
    return result;
}

}  // namespace benchmarks
