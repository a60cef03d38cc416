// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace driver {

constexpr int kFailureExitCode = 3;

void say(const std::string& text);  ///< one line on stderr
[[noreturn]] void end_with_error(const std::string& why);
[[noreturn]] void end_process(int exit_code);  ///< at once: no "save changes?" box, no teardown

/// A watchdog: ends the process with an error if neither of these is called within so many seconds;
/// 0: never. Also while a filter or drawing hangs, which no timer of the GUI notices.
void watch(const std::string& what, unsigned seconds);
void restart_watch();

}  // namespace driver
