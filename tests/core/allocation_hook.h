// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// allocation_hook.cpp replaces a program's operator new. Thread-safe.
namespace allocation_hook {

/// Calls of operator new.
std::size_t count();

/// After `left` more calls throws std::bad_alloc, once, but never from operator new(std::nothrow).
void fail_after(long left);

/// Whether one has failed since fail_after().
bool stop_failing();

}  // namespace allocation_hook
