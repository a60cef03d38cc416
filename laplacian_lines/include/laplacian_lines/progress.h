// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "laplacian_lines/error.h"

namespace laplacian_lines {

/// Called now and then from the thread that called the core, with the part of the work that is done
/// (0..1, never falling) and its stage. Return false to cancel: the call throws Error(Cancelled).
using Progress = std::function<bool(double done, const char* stage)>;

/// Progress of a part of the work, from `begin` to `end` of the whole.
inline Progress part(const Progress& progress, double begin, double end) {
    if (!progress) return {};
    return [=](double done, const char* stage) {
        return progress((1 - done) * begin + done * end, stage);
    };
}

/// @throws Error(Cancelled)
inline void report(const Progress& progress, double done, const char* stage) {
    if (progress && !progress(done, stage))
        refuse("Cancelled; the mesh was not changed.", ErrorCode::Cancelled);
}

}  // namespace laplacian_lines
