// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <shared_mutex>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_style.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute_options.h"
#include "laplacian_lines/progress.h"

namespace python_module {

/// A mesh, its field, and what lines need of both, made when it is first needed. Several threads
/// may ask at once.
class Surface {
public:
    /// @throws laplacian_lines::Error as precompute().
    Surface(laplacian_lines::TriangleMesh mesh, const laplacian_lines::PrecomputeOptions& options,
            const laplacian_lines::Progress& progress);

    /// Without the optional columns, unless the options have asked for them.
    laplacian_lines::Field field() const;
    const laplacian_lines::FieldScale& scale() const { return field_.scale; }
    const laplacian_lines::MeshReport& report() const { return field_.report; }
    /// All lines of a view, as LineExtractor::extract() has them, whatever hides them.
    laplacian_lines::LineSet lines(const laplacian_lines::View& view,
                                   const laplacian_lines::LineStyle& style,
                                   const laplacian_lines::Progress& progress);
    /// What is seen of them, and what is hidden if that is asked for, see LineVisibility::look().
    /// The style says which kinds and how smooth they are.
    std::vector<laplacian_lines::SightLine> visible_lines(
        const laplacian_lines::View& view, const laplacian_lines::LineStyle& style,
        laplacian_lines::SightOptions options, const laplacian_lines::Progress& progress);

private:
    /// What `read` makes of the extractor, which has derivatives if the style needs them.
    template <class Read>
    auto with_extractor(const laplacian_lines::LineStyle& style,
                        const laplacian_lines::Progress& progress, const Read& read);

    const laplacian_lines::TriangleMesh mesh_;
    laplacian_lines::Field field_;
    const bool wants_derivatives_;
    std::unique_ptr<laplacian_lines::LineExtractor> extractor_;
    std::unique_ptr<const laplacian_lines::LineVisibility> visibility_;
    mutable std::shared_mutex parts_;  // guards the extractor, visibility and optional columns
};

}  // namespace python_module
