// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drawn_view.h"
#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/sheet_options.h"

namespace line_drawing {

/// Looks at a mesh from all sides. The mesh and its field have to outlive it.
class Observer {
public:
    /// @throws laplacian_lines::Error: InvalidMesh, EmptyMesh, FieldMismatch, Cancelled.
    Observer(const laplacian_lines::TriangleMesh& mesh, const laplacian_lines::Field& field,
             const laplacian_lines::Progress& progress);

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
                  const laplacian_lines::LineSet& lines, const SheetOptions& options,
                  const laplacian_lines::Progress& progress) const;

    const laplacian_lines::TriangleMesh& mesh_;
    const laplacian_lines::Field& field_;
    const Eigen::AlignedBox3d box_;
    const laplacian_lines::LineExtractor extractor_;
    const laplacian_lines::LineVisibility visibility_;
    laplacian_lines::ExtractionScratch scratch_;
};

}  // namespace line_drawing
