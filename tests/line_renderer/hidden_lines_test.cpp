// SPDX-License-Identifier: GPL-3.0-or-later
// Hidden lines: left out, faint or dashed, by the depth buffer or a texture.
#include <cmath>

#include "gl_test.h"

namespace {

using laplacian_lines::LineKind;
using laplacian_lines::LineSet;
using line_renderer::HiddenLines;
using line_renderer::LineAppearance;
using line_renderer::LinePlacement;

/// Along the middle of a row of pixels, half way in depth.
const LineSet kLine = one_line({{10, 60.5f, 0}, {150, 60.5f, 0}});

LineAppearance appearance_of(HiddenLines hidden) {
    LineAppearance result = black_lines(4);
    result.hidden = hidden;
    return result;
}

class HiddenLinesTest : public LineTest {
protected:
    /// With a surface at this z over the right half.
    QImage line_with_surface_at(double z, const LineAppearance& appearance,
                                const LinePlacement& placement = Canvas::placement(),
                                const LineSet& lines = kLine) {
        canvas_.clear();
        canvas_.put_depth(80, 0, 80, Canvas::height, z);
        return drawn(lines, appearance, placement);
    }
};

/// On both sides of the middle.
void expect_widths(const QImage& picture, double left, double right) {
    for (int x : {20, 50, 76})
        EXPECT_NEAR(ink_of_column(picture, x), left, 0.05) << x;
    for (int x : {84, 110, 140})
        EXPECT_NEAR(ink_of_column(picture, x), right, 0.05) << x;
}

TEST_F(HiddenLinesTest, AreLeftOutBehindASurface) {
    const LineAppearance appearance = appearance_of(HiddenLines::LeftOut);
    expect_widths(line_with_surface_at(0.5, appearance), 4, 0);
    expect_widths(line_with_surface_at(-0.5, appearance), 4, 4);
    expect_widths(line_with_surface_at(0, appearance), 4, 4);
}

/// The surface may be 0.003 diagonals before a line, for contours at least 1.5 edges.
TEST_F(HiddenLinesTest, AreSeenFromALittleBelowTheSurface) {
    const LineAppearance appearance = appearance_of(HiddenLines::LeftOut);
    LinePlacement placement = Canvas::placement();
    placement.diagonal = 10;
    placement.depth_bias_edge = 0.1;
    LineSet outline = kLine;
    const auto expect_limit = [&](LineKind kind, double limit) {
        outline.lines[0].kind = kind;
        expect_widths(line_with_surface_at(limit - 0.001, appearance, placement, outline), 4, 4);
        expect_widths(line_with_surface_at(limit + 0.001, appearance, placement, outline), 4, 0);
    };
    expect_limit(LineKind::Laplacian, 0.03);
    expect_limit(LineKind::Contour, 0.15);
    expect_limit(LineKind::Border, 0.03);
    placement.depth_bias_edge = 0;  // contours follow edges then
    expect_limit(LineKind::Contour, 0.03);
}

/// Even if the surface hides about half of one, as along an outline; not if it goes on for 1.5
/// pixels beyond its middle.
TEST_F(HiddenLinesTest, HaveTheirFullWidthAlongAnEdge) {
    const auto width_under = [&](int y, int rows) {
        canvas_.clear();
        canvas_.put_depth(0, y, Canvas::width, rows, 0.5);
        return ink_of_column(drawn(kLine, appearance_of(HiddenLines::LeftOut)), 80);
    };
    for (int edge : {60, 61})
        EXPECT_NEAR(width_under(0, edge), 4, 0.05) << "from below to " << edge;
    for (int edge : {61, 60})
        EXPECT_NEAR(width_under(edge, Canvas::height - edge), 4, 0.05) << "from above to " << edge;
    EXPECT_EQ(width_under(0, 63), 0);
    EXPECT_EQ(width_under(58, Canvas::height - 58), 0);
}

LineSet contour(bool follows_edge) {
    LineSet result = kLine;
    result.lines[0].kind = LineKind::Contour;
    for (laplacian_lines::LinePoint& point : result.points)
        if (follows_edge) point.gradient = 0;
    return result;
}

/// Their own surface ends there on the screen: what is before them by more than four pixels, such
/// as a fold, hides them.
TEST_F(HiddenLinesTest, AreHiddenByALittleWhereTheyFollowEdges) {
    LinePlacement placement = Canvas::placement();
    placement.diagonal = 5000;
    placement.to_eye.topLeftCorner<3, 3>() *= 0.1;  // clearance: 1.5, a pixel: 0.1
    placement.projection.leftCols<2>() *= 10;
    placement.to_eye(2, 3) = -0.25;  // their depth
    const auto expect_right_half = [&](bool follows_edge, double z, double width) {
        const LineAppearance appearance = appearance_of(HiddenLines::LeftOut);
        expect_widths(line_with_surface_at(z, appearance, placement, contour(follows_edge)), 4,
                      width);
    };
    for (const bool follows_edge : {false, true})
        expect_right_half(follows_edge, 0.1, 4);
    expect_right_half(false, 0.2, 4);
    expect_right_half(true, 0.2, 0);
}

/// Full width beside what they border, hidden a pixel further in.
TEST_F(HiddenLinesTest, AreSeenFromNoFurtherAsideThanAPixelWhereTheyFollowEdges) {
    const auto width_below = [&](int edge, bool follows_edge, double scale) {
        LinePlacement placement = Canvas::placement();
        placement.pixel_scale = scale;
        canvas_.clear();
        canvas_.put_depth(0, 0, Canvas::width, edge, 0.5);
        const LineAppearance appearance = appearance_of(HiddenLines::LeftOut);
        return ink_of_column(drawn(contour(follows_edge), appearance, placement), 80);
    };
    for (const int edge : {60, 61})
        EXPECT_NEAR(width_below(edge, true, 2), 8, 0.05) << edge;
    EXPECT_EQ(width_below(62, true, 2), 0);
    EXPECT_NEAR(width_below(62, false, 2), 8, 0.05);
}

/// At four times the clearance and more behind the surface: no pieces along outlines.
TEST_F(HiddenLinesTest, AreFaintIfWanted) {
    const LineAppearance appearance = appearance_of(HiddenLines::Faint);
    expect_widths(line_with_surface_at(0.5, appearance), 4, 1);
    expect_widths(line_with_surface_at(0.013, appearance), 4, 1);
    expect_widths(line_with_surface_at(0.011, appearance), 4, 0);
    expect_widths(line_with_surface_at(0.002, appearance), 4, 4);
}

TEST_F(HiddenLinesTest, AreDashedIfWanted) {
    const QImage picture = line_with_surface_at(0.5, appearance_of(HiddenLines::Dashed));
    for (int x : {20, 50, 76})
        EXPECT_NEAR(ink_of_column(picture, x), 4, 0.05);
    // Dashes of 5 pixels every 9, from the line's start.
    double ink = 0;
    for (int x = 90; x < 90 + 45; ++x) {
        ink += ink_of_column(picture, x);
        const double along = std::fmod(x + 0.5 - 10, 9);
        const bool is_dash = std::abs(along - 2.5) < 1.9, is_gap = std::abs(along - 7) < 1.4;
        if (is_dash || is_gap) {
            EXPECT_NEAR(ink_of_column(picture, x), is_dash ? 4 : 0, 0.05) << x;
        }
    }
    EXPECT_NEAR(ink, 4 * 25, 2);
}

/// With points and wires drawn, the texture has only the surface. Marks hide nothing, as far as
/// they stand out: √(.1 · (4 √½ + 2)) = .695 for this diagonal, these marks and half the line's
/// width.
TEST_F(HiddenLinesTest, AreThoseBehindTheTextureAndWellBehindTheDepthBuffer) {
    const Rectangles far = Rectangles().add(80, 0, 80, Canvas::height, -0.5),
                     near = Rectangles().add(80, 0, 80, Canvas::height, 0.5);
    line_renderer::SurfaceBuffers buffers;
    LinePlacement placement = Canvas::placement();
    placement.diagonal = 0.1;
    placement.mark_pixels = 4;
    const auto drawn_over = [&](const Rectangles& rectangles, double depth_buffer_z) {
        canvas_.clear();
        canvas_.put_depth(80, 0, 80, Canvas::height, depth_buffer_z);
        const line_renderer::SurfacePointer surface = rectangles.surface();
        placement.depths = depth_.update({layer_of(surface)}, buffers);
        return drawn(kLine, appearance_of(HiddenLines::LeftOut), placement);
    };
    expect_widths(drawn_over(far, 0.68), 4, 4);
    expect_widths(drawn_over(far, 0.71), 4, 0);
    expect_widths(drawn_over(near, -0.9), 4, 0);
}

}  // namespace
