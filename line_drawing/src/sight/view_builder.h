// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/progress.h"
#include "laplacian_lines/triangle_mesh.h"
#include "line_drawing/object.h"
#include "line_drawing/sheet_options.h"
#include "planes/cutting.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// Finds the lines of views of objects, which outlive this: first a view without lines, then
/// prepare() for all sheets, then the lines of each view, then a check of its outlines.
class ViewBuilder {
public:
    /// @throws laplacian_lines::Error(InvalidMesh)
    explicit ViewBuilder(const Objects& objects);

    ViewBuilder(const ViewBuilder&) = delete;
    ViewBuilder& operator=(const ViewBuilder&) = delete;

    /// A view without its lines.
    DrawnView empty_view(const ViewFrame& frame, const SheetOptions& options);
    /// A section, without the surface behind it.
    DrawnView section_view(const Section& section, const SheetOptions& options);
    /// The eye and the light.
    laplacian_lines::View view_of(const DrawnView& drawn, const SheetOptions& options) const;
    /// Prepares visibility, once before add_lines(). @throws laplacian_lines::Error(Cancelled)
    void prepare(const std::vector<SheetOptions>& sheets,
                 const laplacian_lines::Progress& progress);
    /// Adds the visible parts of mesh edges and of `lines`, those within faces by object.
    /// Thread-safe for different views, like the functions below.
    void add_lines(DrawnView& drawn, const std::vector<laplacian_lines::LineSet>& lines,
                   const SheetOptions& options, const laplacian_lines::Progress& progress) const;
    /// Compares outlines with the pixels that the surface covers, `pixel` wide or more, and adds
    /// missing lines, not in perspective or half sections. Returns their length. mm of the object.
    double check_outlines(DrawnView& drawn, const SheetOptions& options, double pixel) const;
    /// Mesh units.
    Eigen::Vector3d object_size() const { return box_.sizes(); }
    Eigen::Vector3d middle() const { return box_.center(); }  ///< of the objects' box
    std::size_t triangle_count() const { return surface_.triangles.size(); }

private:
    using ViewLines = std::vector<laplacian_lines::ViewLine>;

    void add_half_section_lines(DrawnView& drawn, const laplacian_lines::View& view,
                                const std::vector<laplacian_lines::LineSet>& lines,
                                const SheetOptions& options,
                                const laplacian_lines::Progress& progress) const;

    void prepare_cuts();
    void add_silhouettes(DrawnView& drawn, const SheetOptions& options) const;
    std::vector<DrawnLine> draw(const ViewLines& lines, const ViewFrame& frame,
                                const SheetOptions& options) const;

    const Objects objects_;
    const laplacian_lines::TriangleMesh joined_;  ///< empty of a single object, which is not copied
    const laplacian_lines::TriangleMesh& surface_;  ///< all objects
    const Eigen::AlignedBox3d box_;
    std::vector<CuttableMesh> cuttable_;  ///< by object, if there is a section
    std::optional<const laplacian_lines::LineVisibility> visibility_;
    std::vector<laplacian_lines::LineVisibility> alone_;  ///< of each object, if wanted
};

}  // namespace line_drawing
