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

/// Memory that LineExtractor::extract() works in. It keeps what it allocated, so that redraws
/// allocate nothing. One per thread; it can serve any extractor.
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

struct LaplacianForms;

/// The Laplacian of the normals with another kernel than that of an extractor's own field, for this
/// extractor alone: an eighth of its memory. May outlive it, but is of no use then.
class KernelLaplacian {
public:
    ~KernelLaplacian();
    KernelLaplacian(KernelLaplacian&&) noexcept;
    KernelLaplacian& operator=(KernelLaplacian&&) noexcept;

    /// Bytes held by this object.
    std::size_t memory() const;

private:
    friend class LineExtractor;
    explicit KernelLaplacian(std::unique_ptr<const LaplacianForms> forms);
    std::unique_ptr<const LaplacianForms> forms_;
};

/// Extracts the lines of one mesh for any view. Built once from a mesh and its field, both of
/// which may be gone afterwards.
///
/// Source: Zhang, He, Seah, "Laplacian Lines for Real-Time Shape Illustration", section on
/// extraction (zero crossings on edges, gradient test, tracing, strength). Deviations from the
/// paper are described at the members of LineStyle.
class LineExtractor {
public:
    /// Values of the field that are not finite count as zero.
    /// @throws Error(FieldMismatch) if the field has another number of vertices, InvalidMesh,
    /// Cancelled.
    LineExtractor(const TriangleMesh& mesh, const Field& field, const Progress& progress = {});
    ~LineExtractor();
    LineExtractor(LineExtractor&&) noexcept;
    LineExtractor& operator=(LineExtractor&&) noexcept;

    /// Replaces `lines` with the lines of this view. Same input, same output, in the same order.
    /// Safe to call from several threads at once, each with its own scratch and line set.
    /// With `laplacian`, Laplacian lines are the zeros of that one; all else, normals and shape
    /// operators among it, stays that of the extractor's field.
    /// @throws Error(InvalidOption) if a value of the style is out of range or the view is not
    /// finite.
    void extract(const View& view, const LineStyle& style, ExtractionScratch& scratch,
                 LineSet& lines, const KernelLaplacian* laplacian = nullptr) const;

    /// The Laplacian of a field of the extractor's mesh, which differs from its own in the kernel
    /// size and the smoothing of normals alone. Thread-safe.
    /// @throws Error(FieldMismatch, InvalidMesh, EmptyMesh)
    KernelLaplacian laplacian_of(const TriangleMesh& mesh, const Field& field) const;

    /// Adds what kinds of lines need that have LineKindDescription::needs_derivatives: as if the
    /// field had had its derivatives from the beginning. `mesh` is that of the extractor, `field`
    /// its field with derivatives. Nothing is changed if this throws. Not to be called while
    /// another thread extracts.
    /// @throws Error(FieldMismatch)
    void add_derivatives(const TriangleMesh& mesh, const Field& field);

    /// Bytes held by this object.
    std::size_t memory() const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace laplacian_lines
