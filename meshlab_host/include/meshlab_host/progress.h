// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <wrap/callback.h>

#include "laplacian_lines/error.h"
#include "laplacian_lines/progress.h"

namespace meshlab_host {

/// Passes the core's reports on to MeshLab's callback (percent and text; false cancels), which may
/// be null, as the part from `begin` to `end` (0..1). It runs the GUI's event loop: the document
/// may have changed when it returns.
inline laplacian_lines::Progress progressTo(vcg::CallBackPos* callback, double begin = 0,
                                            double end = 1) {
    if (!callback) return {};
    return [=](double done, const char* stage) {
        return callback(int(100 * (begin + (end - begin) * done)), stage);
    };
}

/// Tells the callback, which may be null, that a step begins at `done` (0..1).
/// @throws laplacian_lines::Error(Cancelled)
inline void beginStep(vcg::CallBackPos* callback, double done, const char* step) {
    if (callback && !callback(int(100 * done), step))
        throw laplacian_lines::Error(laplacian_lines::ErrorCode::Cancelled,
                                     "Cancelled; the mesh was not changed.");
}

}  // namespace meshlab_host
