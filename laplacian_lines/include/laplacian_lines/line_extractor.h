// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/line_style.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "laplacian_lines/view.h"

namespace laplacian_lines {

/// Working memory of LineExtractor::extract(), kept so that redraws allocate nothing. One per
/// thread; it can serve any extractor.
class ExtractionScratch {
public:
    ExtractionScratch();
    ~ExtractionScratch();
    ExtractionScratch(ExtractionScratch&&) noexcept;
    ExtractionScratch& operator=(ExtractionScratch&&) noexcept;

private:
    friend class LineExtractor;
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

/// Extracts the lines of one mesh for any view. Built once from a mesh and its field, which need
/// not outlive it. Source: Zhang, He, Xie, Chen, "Laplacian Lines for Real-Time Shape
/// Illustration", section on extraction; the members of LineStyle say where we deviate.
class LineExtractor {
public:
    /// Values of the field that are NaN count as zero, infinite ones as very large.
    /// @throws Error(FieldMismatch, InvalidMesh, EmptyMesh, Cancelled)
    LineExtractor(const TriangleMesh& mesh, const Field& field, const Progress& progress = {});
    ~LineExtractor();
    LineExtractor(LineExtractor&&) noexcept;
    LineExtractor& operator=(LineExtractor&&) noexcept;

    /// Replaces `lines` with the lines of this view, in an order that depends on the input alone.
    /// Thread-safe, each thread with its own scratch and line set.
    /// @throws Error(InvalidOption) if a style value is out of range, or if the view or its light
    /// is not finite or has a direction of length 0
    void extract(const View& view, const LineStyle& style, ExtractionScratch& scratch,
                 LineSet& lines) const;

    /// Adds what kinds with LineKindDescription::needs_derivatives read, as if the field had had
    /// derivatives from the start. Not while another thread extracts. Strong exception guarantee.
    /// @throws Error(FieldMismatch, InvalidMesh, EmptyMesh)
    void add_derivatives(const TriangleMesh& mesh, const Field& field);

    /// Bytes, without lines that do not depend on the view, which are found when first shown.
    std::size_t memory() const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace laplacian_lines
