// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/line_extractor.h"

#include <algorithm>
#include <cmath>

#include "crossings.h"
#include "extractor_data.h"
#include "laplacian_lines/error.h"
#include "polyline_tracing.h"

namespace laplacian_lines {

struct LineExtractor::Data : ExtractorData {
    explicit Data(ExtractorData&& data) : ExtractorData(std::move(data)) {}
};

struct ExtractionScratch::Memory {
    VertexValues values;
    MixedTriangles mixed;
    CrossingGraph graph;
    TracingMemory tracing;
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

/// To local coordinates, times s = 1/|e − c| (perspective) or to unit length (orthographic).
LocalEye to_local(const View& view, const ExtractorData& data) {
    const Eigen::Vector3d eye =
        view.w == 0 ? view.eye : Eigen::Vector3d((view.eye / view.w - data.centre) / data.diagonal);
    const double distance = eye.stableNorm();
    if (!std::isfinite(view.w) || !std::isfinite(distance) || (view.w == 0 && distance == 0))
        throw Error(ErrorCode::InvalidOption, "The view has no finite eye or direction.");
    if (view.w == 0) return {(eye / distance).cast<float>(), 0.f};
    const double scale = 1 / std::max(distance, kLeastEyeDistance);
    return {(eye * scale).cast<float>(), float(scale)};
}

}  // namespace

void LineExtractor::extract(const View& view, const LineStyle& style, ExtractionScratch& scratch,
                            LineSet& lines) const {
    validate(style);
    const LocalEye eye = to_local(view, *data_);
    lines.clear();
    ExtractionScratch::Memory& memory = *scratch.memory_;
    evaluate_vertices(*data_, eye, style, memory.values);
    find_mixed_triangles(*data_, memory.values, memory.mixed);
    const auto extract_kind = [&](const LineRules& rules, LineFunction function,
                                  const std::vector<MixedTriangle>& triangles) {
        find_segments(*data_, eye, rules, memory.values, function, triangles, memory.graph);
        trace_polylines(*data_, rules, memory.graph, memory.tracing, lines);
    };
    if (style.laplacian_lines)
        extract_kind(laplacian_rules(style), &VertexValue::laplacian, memory.mixed.laplacian);
    if (style.contours)
        extract_kind(contour_rules(style), &VertexValue::illumination, memory.mixed.contour);
}

}  // namespace laplacian_lines
