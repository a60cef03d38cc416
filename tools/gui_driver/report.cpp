// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"
#include <unistd.h>
#include <cstdio>

// Of the leak sanitizer, which is only there in a MeshLab with sanitized plugins.
extern "C" int __lsan_do_recoverable_leak_check() __attribute__((weak));

namespace driver {

void say(const std::string& text) {
    std::fprintf(stderr, "meshlab_driver: %s\n", text.c_str());
    std::fflush(stderr);
}

void endWithError(const std::string& why) {
    say("error: " + why);
    endProcess(failure_exit_code);
}

void endProcess(int exitCode) {
    std::fflush(nullptr);
    if (__lsan_do_recoverable_leak_check) __lsan_do_recoverable_leak_check();
    _exit(exitCode);
}

}  // namespace driver
