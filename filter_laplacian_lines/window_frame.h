// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/view_frame.h"
#include "meshlab_host/current_view.h"

/// In world coordinates; `name` is for people.
inline line_drawing::ViewFrame frame_of(const meshlab_host::CurrentView& window,
                                        const std::string& name = "View") {
    return line_drawing::frame_of_axes(
        name, window.towards_viewer, window.up,
        window.is_orthographic ? std::nullopt : std::optional(window.eye));
}
