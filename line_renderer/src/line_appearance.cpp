// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/line_appearance.h"

#include <algorithm>

namespace line_renderer {

LineLooks usualLooks() {
    const auto& kinds = laplacian_lines::line_kinds;
    LineLooks looks;
    std::transform(kinds.begin(), kinds.end(), looks.begin(), [](const auto& kind) {
        return LineLook{QColor(kind.color), usual_line_width * kind.width};
    });
    return looks;
}

}  // namespace line_renderer
