// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of the objects in a drawing, with a kernel for its scale: extractors are kept while memory
// allows, for the next drawing at that scale. If one is asked for at once, the nearest will do.
#include "sight/object_lines.h"

#include <algorithm>
#include <cmath>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/mesh_faults.h"
#include "laplacian_lines/precompute.h"
#include "options/paper_and_pens.h"

namespace line_drawing {
namespace {

using laplacian_lines::Field;
using laplacian_lines::MeshFault;
using laplacian_lines::part;
using laplacian_lines::PrecomputeOptions;
using laplacian_lines::Progress;

constexpr double kFieldShare = 0.8;   // of an object's progress
constexpr double kSameKernel = 0.02;  // relative difference of kernels that count as equal

/// In mesh units; `mm` on paper per mesh unit, `diagonal` that of the mesh's bounding box.
double length_of(const DetailSize& detail, double mm, double diagonal) {
    return detail.is_share ? detail.size * diagonal : detail.size / mm;
}

/// 2 for a detail of 0, 1 for 50, 1/2 for 100.
double kernel_factor(double detail) {
    return std::exp2(1 - detail / 50);
}

/// What tells requests apart: equal for equal lengths in the mesh, negative for shares.
double key_of(const DetailSize& detail, double mm) {
    return detail.is_share ? -detail.size : detail.size / mm;
}

/// Sizes that were asked for are keys here: compute_field() has the object's own.
PrecomputeOptions field_options(const SheetOptions& options, double mm) {
    PrecomputeOptions result;
    result.kernel_size = key_of(options.kernel, mm);
    result.normal_sigma = key_of(options.smoothing, mm);
    const double factor = kernel_factor(options.style.detail);
    result.least_drawn_edges = laplacian_lines::kLeastKernelEdges * std::min(factor, 1.);
    result.drawn_kernel_size =
        factor * kKernelPens * options.pens[std::size_t(LineClass::Inner)] / mm;
    result.curvature_derivatives = options.style.shows.needs_derivatives();
    return result;
}

Field compute_field(const Object& object, PrecomputeOptions wanted, const SheetOptions& options,
                    double mm, const Progress& progress) {
    const double diagonal = bounds_of(object.mesh).diagonal().norm();
    if (options.kernel.size > 0) {
        wanted.drawn_kernel_size = 0;
        wanted.kernel_size = length_of(options.kernel, mm, diagonal);
    }
    try {
        if (options.smoothing.size > 0) {
            const double known = object.mesh.known_edge;
            const double edge =
                known > 0 ? known : laplacian_lines::measure_scale(object.mesh).mean_edge;
            wanted.normal_sigma = length_of(options.smoothing, mm, diagonal) / edge;
        }
        return laplacian_lines::precompute(object.mesh, wanted, progress);
    } catch (const laplacian_lines::Error& error) {
        if (object.name.empty()) throw;
        throw laplacian_lines::Error(error.code(), object.name + ": " + error.what());
    }
}

}  // namespace

ObjectLines::Extractor ObjectLines::given_extractor(const Object& object) {
    const double kernel = object.field ? object.field->scale.kernel_size : object.extractor_kernel,
                 edge = object.field ? object.field->scale.mean_edge : 0;
    const std::shared_ptr<void> no_owner;
    return {{no_owner, object.extractor}, kernel, std::max(kernel, edge), object.field != nullptr};
}

std::size_t ObjectLines::bytes_of(const Extractors& kept) {
    std::size_t sum = 0;
    for (const Extractor& own : kept.extractors)
        if (own.extractor.use_count() > 0) sum += own.extractor->memory();  // not if given
    return sum;
}

double ObjectLines::distance(const Extractors& kept, const PrecomputeOptions& wanted) {
    if (kept.made.curvature_derivatives < wanted.curvature_derivatives) return INFINITY;
    const bool is_asked_alike = kept.made.kernel_size == wanted.kernel_size &&
                                kept.made.normal_sigma == wanted.normal_sigma;
    const double asked = kept.made.drawn_kernel_size, now = wanted.drawn_kernel_size;
    const auto is_same = [&](double kernel) {
        // Requests beyond the limits of kernels get the limit, which is the same for one Detail.
        const bool has_limit = kept.made.least_drawn_edges == wanted.least_drawn_edges;
        const double least = has_limit && asked < (1 - kSameKernel) * kernel ? 0 : asked,
                     most = asked > (1 + kSameKernel) * kernel ? INFINITY : asked;
        return (1 - kSameKernel) * least <= now &&
               now <= (1 + kSameKernel) * std::max(most, kernel);
    };
    double largest = 0;
    for (const Extractor& own : kept.extractors)
        if (!own.is_given && !is_asked_alike)
            return INFINITY;
        else if (!own.is_given && !(kept.is_exact && is_same(own.kernel)))
            largest = std::max({1., largest, own.kernel / now, now / own.kernel});
    return largest;
}

ObjectLines::ObjectLines(const Objects& objects, std::size_t most_bytes)
    : objects_(objects), most_bytes_(most_bytes) {
    Extractors ready{{}, false, {}, {}};
    ready.made.curvature_derivatives = true;
    for (const Object& object : objects) {
        if (!object.extractor) return;
        ready.extractors.push_back(given_extractor(object));
    }
    kept_.push_back(std::move(ready));
}

bool ObjectLines::prepare(const SheetOptions& options, double scale, Kernel kernel,
                          const Progress& progress) {
    validate(options.style);
    const double mm = scale * options.mm_per_unit;
    const PrecomputeOptions wanted = field_options(options, mm);
    const auto nearest =
        std::min_element(kept_.begin(), kept_.end(), [&](const Extractors& a, const Extractors& b) {
            return distance(a, wanted) < distance(b, wanted);
        });
    const double least = nearest == kept_.end() ? INFINITY : distance(*nearest, wanted);
    if (least == 0 || (kernel == Kernel::Nearest && std::isfinite(least))) {
        kept_.splice(kept_.begin(), kept_, nearest);
        return least == 0;
    }
    std::size_t bytes = 0;  // makes room: what was used least recently goes
    for (auto kept = kept_.begin(); kept != kept_.end();)
        kept = (bytes += bytes_of(*kept)) > most_bytes_ ? kept_.erase(kept) : std::next(kept);
    kept_.push_front(compute(options, mm, wanted, progress));
    return true;
}

ObjectLines::Extractors ObjectLines::compute(const SheetOptions& options, double mm,
                                             const PrecomputeOptions& wanted,
                                             const Progress& progress) const {
    Extractors result{wanted, true, {}, {}};
    const auto count = double(objects_.size());
    for (const Object& object : objects_) {
        if (object.field && object.extractor) {
            result.extractors.push_back(given_extractor(object));
            continue;
        }
        const auto done = double(result.extractors.size());
        const Progress own = part(progress, done / count, (done + 1) / count);
        Field computed;
        if (!object.field)
            computed = compute_field(object, wanted, options, mm, part(own, 0, kFieldShare));
        const Field& field = object.field ? *object.field : computed;
        for (const MeshFault fault : laplacian_lines::faults_of(field.report))
            result.remarks.push_back((object.name.empty() ? "" : object.name + ": ") +
                                     describe(fault, field.report));
        result.extractors.push_back({std::make_shared<const laplacian_lines::LineExtractor>(
                                         object.mesh, field, part(own, kFieldShare, 1)),
                                     field.scale.kernel_size,
                                     std::max(field.scale.kernel_size, field.scale.mean_edge),
                                     object.field != nullptr});
    }
    return result;
}

double ObjectLines::largest(double Extractor::*size) const {
    double largest = 0;
    for (const Extractor& own : in_use().extractors)
        largest = std::max(largest, own.*size);
    return largest;
}

std::vector<laplacian_lines::LineSet> ObjectLines::extract(
    const laplacian_lines::View& view, const laplacian_lines::LineStyle& style) {
    std::vector<laplacian_lines::LineSet> lines;
    for (const Extractor& own : in_use().extractors)
        lines.push_back(laplacian_lines::extract_on_surface(*own.extractor, view, style, scratch_));
    return lines;
}

}  // namespace line_drawing
