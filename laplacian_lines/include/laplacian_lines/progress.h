// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace laplacian_lines {

/// Called now and then from the thread that called the core, with the part of the work that is done
/// (0..1, never falling) and its stage. Return false to cancel: the call throws Error(Cancelled).
using Progress = std::function<bool(double done, const char* stage)>;

}  // namespace laplacian_lines
