// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_style.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/progress.h"
#include "line_drawing/view_strokes.h"

namespace python_module {

using namespace laplacian_lines;

/// A mesh, its field, and what lines of the refined mesh need, computed on demand. Thread-safe.
class Surface {
public:
    /// @throws laplacian_lines::Error as precompute()
    Surface(TriangleMesh mesh, const PrecomputeOptions& options, const Progress& progress);

    /// Optional columns only if the options asked for them.
    Field field() const;
    const FieldScale& scale() const { return field_.scale; }
    const MeshReport& report() const { return field_.report; }

    /// All lines of a view as LineExtractor::extract(), none of them marked as hidden or an
    /// outline.
    std::vector<ViewLine> lines(const View& view, const LineStyle& style, const Progress& progress);

    /// The visible lines, and the hidden ones if asked for, see LineVisibility::visible_lines().
    /// The style has the kinds and the smoothing.
    std::vector<ViewLine> visible_lines(const View& view, const LineStyle& style,
                                        VisibilityOptions options, const Progress& progress);

    /// See line_drawing::strokes_of(); with the field's kernel if the options have one.
    std::vector<ViewLine> strokes(const line_drawing::ViewFrame& frame,
                                  const line_drawing::SheetOptions& options, double size,
                                  const Progress& progress);

private:
    const TriangleMesh& drawn_mesh(const Progress& progress);
    Field& drawn_field(const Progress& progress);
    const LineExtractor& extractor(const LineStyle& style, const Progress& progress);

    const TriangleMesh mesh_;
    const PrecomputeOptions options_;
    Field field_;
    bool may_be_refined_;  ///< until tried; never without welding, which refined() does
    std::optional<TriangleMesh> finer_;
    std::optional<Field> finer_field_;
    std::unique_ptr<LineExtractor> extractor_;
    std::unique_ptr<const LineVisibility> visibility_;
    mutable std::mutex parts_;  // one view at a time, which the core computes on all processors
};

}  // namespace python_module
