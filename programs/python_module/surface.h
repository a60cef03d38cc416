// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_style.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/progress.h"

namespace python_module {

/// A mesh, its field, and what lines need of them, made on demand. Thread-safe.
class Surface {
public:
    /// @throws laplacian_lines::Error as precompute()
    Surface(laplacian_lines::TriangleMesh mesh, const laplacian_lines::PrecomputeOptions& options,
            const laplacian_lines::Progress& progress);

    /// Optional columns only if the options asked for them.
    laplacian_lines::Field field() const;
    const laplacian_lines::FieldScale& scale() const { return field_.scale; }
    const laplacian_lines::MeshReport& report() const { return field_.report; }
    /// All lines of a view, hidden or not, as LineExtractor::extract().
    laplacian_lines::LineSet lines(const laplacian_lines::View& view,
                                   const laplacian_lines::LineStyle& style,
                                   const laplacian_lines::Progress& progress);
    /// The visible lines, and the hidden ones if asked for, see LineVisibility::look(). The style
    /// has the kinds and the smoothing.
    std::vector<laplacian_lines::SightLine> visible_lines(
        const laplacian_lines::View& view, const laplacian_lines::LineStyle& style,
        laplacian_lines::SightOptions options, const laplacian_lines::Progress& progress);

private:
    /// With derivatives if the style needs them.
    const laplacian_lines::LineExtractor& extractor(const laplacian_lines::LineStyle& style,
                                                    const laplacian_lines::Progress& progress);

    const laplacian_lines::TriangleMesh mesh_;
    laplacian_lines::Field field_;
    const bool wants_derivatives_;
    std::unique_ptr<laplacian_lines::LineExtractor> extractor_;
    std::unique_ptr<const laplacian_lines::LineVisibility> visibility_;
    mutable std::mutex parts_;  // one view at a time, which the core computes on all processors
};

}  // namespace python_module
