// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace line_renderer {

/// What is drawn of the parts of lines that the surface hides.
enum class HiddenLines { LeftOut, Faint, Dashed };

/// How lines look.
struct LineAppearance {
    QColor color = Qt::black;          ///< of Laplacian lines
    QColor contour_color = Qt::black;  ///< of occluding contours
    HiddenLines hidden = HiddenLines::LeftOut;
    double width = 1.6;           ///< pixels, of a Laplacian line of full weight
    double contour_factor = 1.3;  ///< width of contours in Laplacian line widths
};

}  // namespace line_renderer
