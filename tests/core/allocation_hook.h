// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// Linking allocation_hook.cpp into a program replaces its operator new. Any thread may call these.
namespace allocation_hook {

/// How often operator new has been called.
std::size_t count();

/// Lets `left` calls succeed, then throws std::bad_alloc: once, or each time if `for_good`. Never
/// of operator new(std::nothrow).
void fail_after(long left, bool for_good);

/// From now on none fails. Returns whether one has failed since fail_after().
bool stop_failing();

}  // namespace allocation_hook
