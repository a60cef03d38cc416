// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/sheet_options.h"
#include "sight/object_lines.h"
#include "views/drawn_view.h"
#include "views/joined_surface.h"

namespace line_drawing {

/// A view without its lines, of surfaces with these bounds.
DrawnView standBefore(const laplacian_lines::TriangleMesh& surface,
                      const Eigen::AlignedBox3d& bounds, const ViewFrame& frame,
                      const SheetOptions& options);
/// The same for a section, without what it cuts.
DrawnView standBefore(const laplacian_lines::TriangleMesh& surface,
                      const Eigen::AlignedBox3d& bounds, const Section& section,
                      const SheetOptions& options);

/// Looks at objects from all sides. They have to outlive it.
class Observer {
public:
    /// @throws laplacian_lines::Error: InvalidMesh, EmptyMesh, FieldMismatch, Cancelled.
    Observer(const Objects& objects, const laplacian_lines::Progress& progress);

    /// A view without its lines.
    DrawnView stand(const ViewFrame& frame, const SheetOptions& options) const;
    /// Before lines are looked at: as fine ones as a scale asks for, see ObjectLines.
    void makeReady(const SheetOptions& options, double scale,
                   const laplacian_lines::Progress& progress) {
        lines_.makeReady(options, scale, progress);
    }
    /// The largest √h, mesh units.
    double kernelSize() const { return lines_.kernelSize(); }
    /// Adds the lines that are seen.
    void look(DrawnView& drawn, const SheetOptions& options,
              const laplacian_lines::Progress& progress);
    /// Holds the outlines against what the surface covers, in pixels of this size, mm of the
    /// object, and adds lines where there is none. Returns how long what was missing is, in mm.
    double checkOutlines(DrawnView& drawn, const SheetOptions& options, double pixel) const;
    /// What a section cuts, without what lies behind it.
    DrawnView cut(const Section& section, const SheetOptions& options) const;
    /// In units of the mesh.
    Eigen::Vector3d objectSize() const { return box_.sizes(); }

private:
    using SightLines = std::vector<laplacian_lines::SightLine>;

    void lookHalf(DrawnView& drawn, const laplacian_lines::View& view,
                  const std::vector<laplacian_lines::LineSet>& lines, const SheetOptions& options,
                  const laplacian_lines::Progress& progress) const;

    void addSilhouettes(DrawnView& drawn, const SheetOptions& options);
    std::vector<DrawnLine> draw(const SightLines& lines, const ViewFrame& frame,
                                const SheetOptions& options) const;

    const Objects objects_;
    const JoinedSurface surface_;
    const Eigen::AlignedBox3d box_;
    const laplacian_lines::LineVisibility visibility_;
    ObjectLines lines_;
    std::vector<laplacian_lines::LineVisibility> alone_;  ///< of each object, when first wanted
};

}  // namespace line_drawing
