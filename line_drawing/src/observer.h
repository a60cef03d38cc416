// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drawn_view.h"
#include "joined_surface.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// Looks at objects from all sides. They have to outlive it.
class Observer {
public:
    /// @throws laplacian_lines::Error: InvalidMesh, EmptyMesh, FieldMismatch, Cancelled.
    Observer(const Objects& objects, const laplacian_lines::Progress& progress);

    /// A view without its lines.
    DrawnView stand(const ViewFrame& frame, const SheetOptions& options) const;
    /// Adds the lines that are seen.
    void look(DrawnView& drawn, const SheetOptions& options,
              const laplacian_lines::Progress& progress);
    /// What a section cuts, without what lies behind it.
    DrawnView cut(const Section& section, const SheetOptions& options) const;
    /// In units of the mesh.
    Eigen::Vector3d objectSize() const { return box_.sizes(); }

private:
    void lookHalf(DrawnView& drawn, const laplacian_lines::View& view,
                  const std::vector<laplacian_lines::LineSet>& lines, const SheetOptions& options,
                  const laplacian_lines::Progress& progress) const;

    /// With what is hidden, if that is to be drawn.
    std::vector<DrawnLine> draw(const laplacian_lines::LineParts& parts, const ViewFrame& frame,
                                const SheetOptions& options) const;

    const Objects objects_;
    const JoinedSurface surface_;
    const Eigen::AlignedBox3d box_;
    const std::vector<laplacian_lines::LineExtractor> extractors_;
    const laplacian_lines::LineVisibility visibility_;
    laplacian_lines::ExtractionScratch scratch_;
};

}  // namespace line_drawing
