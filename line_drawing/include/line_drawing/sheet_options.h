// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "laplacian_lines/line_style.h"
#include "line_drawing/view_frame.h"

namespace line_drawing {

/// Layout of the views around the front view (ISO 5456-2). First angle: the view from the left is
/// on the right, that from above below. Third angle: on the left, above.
enum class Arrangement { FirstAngle, ThirdAngle };

/// Tapered: widths follow the lines' weights, as filled areas. Plain: of constant width, for
/// plotters and CAD.
enum class StrokeStyle { Tapered, Plain };

/// How cut walls are drawn: hatched, black, or as outlines.
enum class WallStyle { Hatched, Filled, None };

/// Widths of lines. Illustrator: outlines are wider than contours within them, these wider than
/// edges. Iso (128): all visible edges are as wide as outlines, other lines half as wide.
enum class Weights { Illustrator, Iso };

/// Areas to add, enclosed by the outlines of the drawing, or of each object alone.
enum class OutlineArea { None, Filled, Objects };

/// Text in fonts of the reader, or letters as areas, for print shops and plotters.
enum class TextStyle { Letters, Outlines };

/// Of outlines, borders and creases.
enum class HiddenLines { LeftOut, Dashed };

enum class LineClass {
    Outline,  ///< contours and borders before nothing: the edge of the drawing, mostly closed
    Contour,  ///< contours and borders before a farther part of the surface
    Edge,     ///< creases: edges of the form between two faces that are seen
    Inner,    ///< ridges, clear Laplacian lines and other lines within a face
    Fine,     ///< faint Laplacian lines, hatching
    Section,  ///< where a section cuts the surface
    Hidden    ///< outlines, borders and creases behind the surface, dashed
};
constexpr std::size_t kLineClassCount = 7;

/// Widths in mm, by LineClass.
using Pens = std::array<double, kLineClassCount>;

constexpr Pens pens_of(Weights weights) {
    if (weights == Weights::Iso) return {0.5, 0.5, 0.5, 0.25, 0.25, 0.5, 0.25};
    return {0.5, 0.35, 0.25, 0.25, 0.13, 0.35, 0.18};
}

/// Lines on paper are traced whole.
inline laplacian_lines::LineStyle style_on_paper(laplacian_lines::LineStyle style = {}) {
    style.whole_lines = true;
    style.least_concavity = -1;
    return style;
}

/// A length: 0 if automatic; in mm on paper; or as a share of the diagonal of the object's bounding
/// box.
struct DetailSize {
    double size = 0;
    bool is_share = false;
};

/// Options that need no parsing; the rest of SheetOptions is parsed from SheetChoices.
struct SheetLook {
    UpAxis up = UpAxis::Y;  ///< of sections; views have their own
    Arrangement arrangement = Arrangement::FirstAngle;
    StrokeStyle strokes = StrokeStyle::Tapered;
    WallStyle wall = WallStyle::Hatched;
    HiddenLines hidden = HiddenLines::LeftOut;
    OutlineArea area = OutlineArea::None;
    TextStyle text = TextStyle::Letters;
    /// Names of views, if there are several; scale bar, projection symbol, and the notes: title,
    /// scale, size and source.
    bool has_annotations = true;
};

struct SheetOptions : SheetLook {
    std::vector<ViewFrame> views;
    std::vector<Section> sections;  ///< drawn after the views
    /// Drawn over true length; 0: the largest standard scale that fits the paper. Views in
    /// perspective have none: beside others they have their scale at the centre of the object,
    /// alone they fill the paper.
    double scale = 0;
    double mm_per_unit = 1;    ///< true length of a unit of the mesh
    std::string paper = "a4";  ///< a5 to a0, or "fit": as large as the drawing
    /// Drawings of less than 40 mm get finer ones.
    Pens pens = pens_of(Weights::Illustrator);
    /// √h of the inner lines. 0: four inner pens, times 2 to 1/2 by style.detail, limited by the
    /// edges of the mesh.
    DetailSize kernel;
    /// Standard deviation of the smoothing of normals. 0: by the mesh's roughness, at least √h / 4,
    /// but none on CAD meshes.
    DetailSize smoothing;
    std::string title;   ///< empty: none
    std::string source;  ///< name of the file of the object; empty: none
    laplacian_lines::LineStyle style = style_on_paper();
    /// Towards a distant light for the Laplacian lines, in each view: x right, y up, z to the
    /// viewer. Without one it is at the eye.
    std::optional<Eigen::Vector3d> light;
};

/// "a5" to "a0", and "fit".
std::vector<const char*> paper_names();

/// From "1:2", "2:1" or "fit" (0). @throws laplacian_lines::Error(InvalidOption)
double parse_scale(std::string_view text);
/// From "auto", "1mm" (on paper), "0.9%". @throws laplacian_lines::Error(InvalidOption)
DetailSize parse_detail_size(std::string_view text);
/// "1:2" for 0.5.
std::string scale_text(double scale);
/// "50.0 × 20.0 × 1.00 mm", or in µm, m, km.
std::string size_text(const Eigen::Vector3d& mm, const char* times = " × ");
/// "1", "0.85" or "230", of mm on paper.
std::string kernel_text(double mm);

}  // namespace line_drawing
