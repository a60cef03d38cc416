// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>
#include <array>
#include <optional>

#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/line_style.h"

namespace meshlab_host {

/// In the order of laplacian_lines::kLineKinds.
using KindColors = std::array<QRgb, laplacian_lines::kLineKindCount>;

KindColors usual_kind_colors();

/// The settings of the decoration, for filters that use them.
struct DrawnStyle {
    laplacian_lines::LineStyle style;
    std::optional<double> light_azimuth;  ///< see towards_light(); without one it is at the eye
    bool shows_hidden = false;            ///< also lines that the surface hides
    KindColors colors = usual_kind_colors();
};

/// Stored as a property of the application, numbers by their names: nothing else is common to two
/// plugins in every version of MeshLab. GUI thread only.
void note_drawn_style(const DrawnStyle& drawn);

/// @throws laplacian_lines::Error(InvalidOption) if nothing was noted, as without a window. GUI
/// thread only.
DrawnStyle require_drawn_style();

}  // namespace meshlab_host
