// SPDX-License-Identifier: GPL-3.0-or-later
// A redraw:
//  1. The eye goes into local coordinates, and the style becomes rules for each kind of lines.
//  2. Strips of all kinds are found, cluster by cluster (strips.cpp).
//  3. Strips of a kind are joined across clusters and traced to lines (strip_tracing.cpp).
//  4. Lines are finished (line_finishing.cpp).
//  5. Lines that do not depend on the view are appended (fixed/).
#include "laplacian_lines/line_extractor.h"

#include <algorithm>
#include <cmath>

#include "clusters/extractor_data.h"
#include "fixed/fixed_lines.h"
#include "laplacian_lines/error.h"
#include "redraw/line_finishing.h"
#include "rules/thresholds.h"
#include "system/three_floats.h"

namespace laplacian_lines {

struct LineExtractor::Data : ExtractorData {
    explicit Data(ExtractorData&& data) : ExtractorData(std::move(data)) {}
    mutable FixedLines fixed_lines;  // thread-safe
};

struct ExtractionScratch::Memory {
    FoundStrips found;
    JoiningMemory joining;
    PartMemory parts;
    TracedLines traced;
    FinishingMemory finishing;
};

ExtractionScratch::ExtractionScratch() : memory_(std::make_unique<Memory>()) {}
ExtractionScratch::~ExtractionScratch() = default;
ExtractionScratch::ExtractionScratch(ExtractionScratch&&) noexcept = default;
ExtractionScratch& ExtractionScratch::operator=(ExtractionScratch&&) noexcept = default;

LineExtractor::LineExtractor(const TriangleMesh& mesh, const Field& field, const Progress& progress)
    : data_(std::make_unique<Data>(build_extractor_data(mesh, field, progress))) {}
LineExtractor::~LineExtractor() = default;
LineExtractor::LineExtractor(LineExtractor&&) noexcept = default;
LineExtractor& LineExtractor::operator=(LineExtractor&&) noexcept = default;

void LineExtractor::add_derivatives(const TriangleMesh& mesh, const Field& field) {
    laplacian_lines::add_derivatives(mesh, field, *data_);
}

std::size_t LineExtractor::memory() const {
    return data_->memory();
}

namespace {

// In D: an eye nearer to the centre gets the scale of one at this distance, which is finite.
constexpr double kLeastEyeDistance = 0.01;

LocalEye direction_to_local(const Eigen::Vector3d& direction, const char* complaint) {
    const double length = direction.stableNorm();
    if (!std::isfinite(length) || length == 0) refuse(complaint);
    return {(direction / length).cast<float>(), 0.f};
}

/// To local coordinates; positions are scaled to the unit distance from the centre, or less near
/// it, directions to unit length.
LocalEye eye_to_local(const View& view, const ExtractorData& data) {
    constexpr const char* complaint = "The view has no finite eye or direction.";
    if (view.w == 0) return direction_to_local(view.eye, complaint);
    const Eigen::Vector3d eye = (view.eye / view.w - data.centre) / data.diagonal;
    const double distance = eye.stableNorm();
    if (!std::isfinite(view.w) || !std::isfinite(distance)) refuse(complaint);
    const double scale = 1 / std::max(distance, kLeastEyeDistance);
    return {(eye * scale).cast<float>(), float(scale)};
}

/// A bound of n·v for n·v/|v| that needs no |v| and never refuses too much: local points are within
/// 1/2 of the centre, so |v| is within w/2 of |e|.
float least_scaled_facing(float least_facing, const LocalEye& eye) {
    const float length = length_of(eye.eye) + (least_facing < 0 ? eye.w : -eye.w) / 2;
    return least_facing * std::max(length, 0.f);
}

void set_eye(const LocalEye& eye, float out[4]) {
    Eigen::Map<Eigen::Vector4f>(out) << eye.eye, eye.w;
}

/// Whether lines of a kind that is shown are edges of the mesh.
bool is_on_edges(LineKind kind, const LineStyle& style, const ExtractorData& data) {
    return kind == LineKind::Contour && style.shows[kind] && style.exact_outlines &&
           !data.horizon.edges.empty();
}

ExtractionTask make_task(const View& view, const LineStyle& style, const LocalEye& eye,
                         const ExtractorData& data) {
    ExtractionTask task;
    const LocalEye light =
        view.light ? direction_to_local(*view.light, "The light has no finite direction.") : eye;
    set_eye(eye, task.eye);
    set_eye(light, task.light);
    task.light_at_eye = !view.light;
    for (unsigned number = 0; number < kStripKindCount; ++number) {
        const LineKind kind = kStripKinds[number];
        LineRules rules = strip_rules(kind, style, task.light_at_eye);
        rules.kind = kind;
        rules.kernel_size = data.kernel_size;
        rules.slope_scale = float(std::pow(
            kind == LineKind::Laplacian ? data.laplacian_squared_scale : data.squared_scale, 1.5));
        if (data.is_sheet) rules.concave_thinning = LineRules::kNoThinning;
        const float least_facing =
            rules.leave_out_away ? 0 : least_scaled_facing(rules.least_facing, eye);
        const bool on_edges = is_on_edges(kind, style, data);
        if (on_edges) rules.smoothing_passes = 0;  // edges stay where they are
        const bool wanted = !on_edges && style.shows[kind] && can_extract(kind, data);
        task.kinds[number] = {wanted, least_facing, rules};
    }
    return task;
}

}  // namespace

void LineExtractor::extract(const View& view, const LineStyle& style, ExtractionScratch& scratch,
                            LineSet& lines) const {
    validate(style);
    const LocalEye eye = eye_to_local(view, *data_);
    const ExtractionTask task = make_task(view, style, eye, *data_);
    ExtractionScratch::Memory& memory = *scratch.memory_;
    find_strips(*data_, task, memory.found);
    memory.traced.clear();
    for (unsigned kind = 0; kind < kStripKindCount; ++kind) {
        const bool on_edges = is_on_edges(kStripKinds[kind], style, *data_);
        if (on_edges) append_horizon(data_->horizon, eye, kind, memory.found);
        join_strips(memory.found, kind, on_edges ? data_->vertex_count : data_->border_edge_count,
                    memory.joining);
        trace_lines(task.kinds[kind].rules, memory.joining.strips[kind], memory.parts,
                    memory.traced);
    }
    lines.origin = data_->origin;
    finish_lines(*data_, memory.traced, memory.finishing, lines);
    data_->fixed_lines.append(*data_, eye, style, lines);
}

}  // namespace laplacian_lines
