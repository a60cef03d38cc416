// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace driver {

constexpr int failure_exit_code = 3;

void say(const std::string& text);                       // one line on stderr
[[noreturn]] void endWithError(const std::string& why);  // from any thread
[[noreturn]] void endProcess(int exitCode);  // at once: no "save changes?" box, no teardown

}  // namespace driver
