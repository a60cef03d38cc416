// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// allocation_hook.cpp replaces a program's operator new. Thread-safe.
namespace allocation_hook {

/// Calls of operator new.
std::size_t count();

/// Throws std::bad_alloc once, after `left` more calls; operator new(std::nothrow) does not count.
void fail_after(long left);

/// Whether one has failed since fail_after().
bool stop_failing();

}  // namespace allocation_hook
