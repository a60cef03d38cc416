// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/progress.h"

namespace line_drawing {

/// The progress of a part of a longer work, which is done from `begin` to `end`.
inline laplacian_lines::Progress part(const laplacian_lines::Progress& progress, double begin,
                                      double end) {
    if (!progress) return {};
    return [=](double done, const char* stage) {
        return progress((1 - done) * begin + done * end, stage);
    };
}

}  // namespace line_drawing
