// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace laplacian_lines {

/// Called now and then, always from the thread that called the core, with the part of the work that
/// is done (0..1, never falling) and what is being done. Returning false cancels: the call then
/// throws Error(Cancelled). An empty function means no reports.
using Progress = std::function<bool(double done, const char* stage)>;

}  // namespace laplacian_lines
