// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/line_extractor.h"

#include <algorithm>
#include <cmath>

#include "crossings.h"
#include "extractor_data.h"
#include "fixed_lines.h"
#include "laplacian_lines/error.h"
#include "mesh_edge_lines.h"
#include "polyline_tracing.h"

namespace laplacian_lines {

struct LineExtractor::Data : ExtractorData {
    explicit Data(ExtractorData&& data) : ExtractorData(std::move(data)) {}
    mutable FixedLines fixed_lines;  // thread-safe
};

struct ExtractionScratch::Memory {
    VertexValues values;
    MixedTriangles mixed;
    CrossingGraph graph;
    TracingMemory tracing;
    SilhouetteMemory silhouettes;
};

ExtractionScratch::ExtractionScratch() : memory_(std::make_unique<Memory>()) {}
ExtractionScratch::~ExtractionScratch() = default;
ExtractionScratch::ExtractionScratch(ExtractionScratch&&) noexcept = default;
ExtractionScratch& ExtractionScratch::operator=(ExtractionScratch&&) noexcept = default;

LineExtractor::LineExtractor(const TriangleMesh& mesh, const Field& field)
    : data_(std::make_unique<const Data>(build_extractor_data(mesh, field))) {}
LineExtractor::~LineExtractor() = default;
LineExtractor::LineExtractor(LineExtractor&&) noexcept = default;
LineExtractor& LineExtractor::operator=(LineExtractor&&) noexcept = default;

std::size_t LineExtractor::memory() const {
    return data_->memory();
}

namespace {

// An eye this close to the centre, in D, is inside the object, where no scale makes sense.
constexpr double kLeastEyeDistance = 0.01;

LocalEye direction_to_local(const Eigen::Vector3d& direction, const char* complaint) {
    const double length = direction.stableNorm();
    if (!std::isfinite(length) || length == 0) throw Error(ErrorCode::InvalidOption, complaint);
    return {(direction / length).cast<float>(), 0.f};
}

/// To local coordinates, times s = 1/|e − c| (perspective) or to unit length (directions).
LocalView to_local(const View& view, const ExtractorData& data) {
    constexpr const char* complaint = "The view has no finite eye or direction.";
    LocalView local;
    if (view.w == 0) {
        local.eye = direction_to_local(view.eye, complaint);
    } else {
        const Eigen::Vector3d eye = (view.eye / view.w - data.centre) / data.diagonal;
        const double distance = eye.stableNorm();
        if (!std::isfinite(view.w) || !std::isfinite(distance))
            throw Error(ErrorCode::InvalidOption, complaint);
        const double scale = 1 / std::max(distance, kLeastEyeDistance);
        local.eye = {(eye * scale).cast<float>(), float(scale)};
    }
    local.light = view.light ? direction_to_local(*view.light, "The light has no finite direction.")
                             : local.eye;
    local.light_at_eye = !view.light;
    return local;
}

}  // namespace

void LineExtractor::extract(const View& view, const LineStyle& style, ExtractionScratch& scratch,
                            LineSet& lines) const {
    validate(style);
    const LocalView local = to_local(view, *data_);
    lines.clear();
    ExtractionScratch::Memory& memory = *scratch.memory_;
    evaluate_vertices(*data_, local, style, memory.values);
    find_mixed_triangles(*data_, memory.values, memory.mixed);
    const auto extract_kind = [&](const LineRules& rules, LineFunction function,
                                  const std::vector<MixedTriangle>& triangles) {
        find_segments(*data_, local, rules, memory.values, function, triangles, memory.graph);
        trace_polylines(*data_, rules, memory.graph, memory.tracing, lines);
    };
    LineRules rules = laplacian_rules(style);
    if (view.light) rules.contour_clearance = 0;  // lines of another light follow no contours
    if (style.laplacian_lines) extract_kind(rules, &VertexValue::laplacian, memory.mixed.laplacian);
    data_->fixed_lines.append(*data_, local.eye, style, lines);
    if (style.contours && style.mesh_silhouettes) {
        LineRules silhouette_rules = contour_rules(style);
        silhouette_rules.smoothing_passes = 0;  // exact is what they are for
        append_silhouettes(*data_, data_->fixed_lines.mesh_edges(*data_), local.eye,
                           silhouette_rules, memory.silhouettes, memory.tracing, lines);
    } else if (style.contours)
        extract_kind(contour_rules(style), &VertexValue::facing, memory.mixed.contour);
}

}  // namespace laplacian_lines
