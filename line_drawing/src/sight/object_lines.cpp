// SPDX-License-Identifier: GPL-3.0-or-later
#include "sight/object_lines.h"

#include <algorithm>
#include <cmath>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/mesh_faults.h"
#include "laplacian_lines/precompute.h"
#include "line_drawing/object.h"
#include "options/progress_part.h"

namespace line_drawing {
namespace {

using laplacian_lines::Field;
using laplacian_lines::MeshFault;
using laplacian_lines::PrecomputeOptions;
using laplacian_lines::Progress;

constexpr double field_share = 0.8;   // of the time
constexpr double same_kernel = 0.02;  // a share: the lines of such kernels are the same

/// Mesh units; `diagonal` is that of the mesh's bounding box.
double lengthOf(const DetailSize& detail, double mm, double diagonal) {
    return detail.is_share ? detail.size * diagonal : detail.size / mm;
}

/// 2 at 0, 1 at 50, 1/2 at 100.
double kernelFactor(double detail) {
    return std::exp2(1 - detail / 50);
}

/// `mm`: on paper, per mesh unit.
PrecomputeOptions fieldOptions(const SheetOptions& options, double mm) {
    PrecomputeOptions result;
    result.drawn_kernel_size = kernelFactor(options.style.detail) *
                               laplacian_lines::kDrawnKernelWidths *
                               options.pens[std::size_t(LineClass::Inner)] / mm;
    result.curvature_derivatives = options.style.shows.needs_derivatives();
    return result;
}

Field computeField(const Object& object, PrecomputeOptions wanted, const SheetOptions& options,
                   double mm, const Progress& progress) {
    const double diagonal = boundsOf(object.mesh).diagonal().norm();
    if (options.kernel.size > 0) {
        wanted.drawn_kernel_size = 0;
        wanted.kernel_size = lengthOf(options.kernel, mm, diagonal);
    }
    try {
        if (options.smoothing.size > 0)
            wanted.normal_sigma = lengthOf(options.smoothing, mm, diagonal) /
                                  laplacian_lines::measure_scale(object.mesh, wanted).mean_edge;
        return laplacian_lines::precompute(object.mesh, wanted, progress);
    } catch (const laplacian_lines::Error& error) {
        if (object.name.empty()) throw;
        throw laplacian_lines::Error(error.code(), object.name + ": " + error.what());
    }
}

}  // namespace

void ObjectLines::makeReady(const SheetOptions& options, double scale, const Progress& progress) {
    validate(options.style);
    const double mm = scale * options.mm_per_unit;
    const PrecomputeOptions wanted = fieldOptions(options, mm);
    const bool are_given = std::all_of(objects_.begin(), objects_.end(),
                                       [](const Object& object) { return object.field; });
    const bool are_equal = std::abs(wanted.drawn_kernel_size - made_.drawn_kernel_size) <=
                               same_kernel * made_.drawn_kernel_size &&
                           (made_.curvature_derivatives || !wanted.curvature_derivatives);
    if (extractors_.size() == objects_.size() && (are_given || are_equal)) return;
    extractors_.clear();
    kernel_size_ = 0;
    remarks_.clear();
    made_ = wanted;
    const auto count = double(objects_.size());
    for (const Object& object : objects_) {
        const auto done = double(extractors_.size());
        const Progress own = part(progress, done / count, (done + 1) / count);
        Field computed;
        if (!object.field)
            computed = computeField(object, wanted, options, mm, part(own, 0, field_share));
        const Field& field = object.field ? *object.field : computed;
        kernel_size_ = std::max(kernel_size_, field.scale.kernel_size);
        for (const MeshFault fault : laplacian_lines::faults_of(field.report))
            if (fault != MeshFault::CoarseKernel)  // as the scale or the user asks for
                remarks_.push_back((object.name.empty() ? "" : object.name + ": ") +
                                   describe(fault, field.report));
        extractors_.emplace_back(object.mesh, field, part(own, field_share, 1));
    }
}

std::vector<laplacian_lines::LineSet> ObjectLines::extract(
    const laplacian_lines::View& view, const laplacian_lines::LineStyle& style) {
    std::vector<laplacian_lines::LineSet> lines;
    for (const laplacian_lines::LineExtractor& extractor : extractors_)
        lines.push_back(laplacian_lines::extract_on_surface(extractor, view, style, scratch_));
    return lines;
}

}  // namespace line_drawing
