// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>
#include <array>
#include <optional>

#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/line_style.h"
#include "meshlab_host/camera.h"

namespace meshlab_host {

/// A color for each of laplacian_lines::line_kinds, in their order.
using KindColors = std::array<QRgb, laplacian_lines::line_kind_count>;

/// Those of laplacian_lines::line_kinds.
KindColors usualKindColors();

/// What the decoration draws, for filters that do the same.
struct DrawnStyle {
    laplacian_lines::LineStyle style;
    std::optional<CameraLight> light;  ///< turns with the camera; without one it is at the eye
    bool shows_hidden = false;         ///< also lines that the surface hides
    KindColors colors = usualKindColors();
};

/// The decoration notes what it draws with as a property of the application, by the keys of the
/// parameters: the only thing that two plugins of any version of MeshLab have in common. GUI thread
/// only.
void noteDrawnStyle(const DrawnStyle& drawn);

/// What was noted last; empty if nothing was, as in programs without a window. GUI thread only.
std::optional<DrawnStyle> drawnStyle();

}  // namespace meshlab_host
