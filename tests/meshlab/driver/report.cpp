// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"
#include <unistd.h>
#include <cstdio>

namespace driver {

void say(const std::string& text) {
    std::fprintf(stderr, "meshlab_driver: %s\n", text.c_str());
    std::fflush(stderr);
}

void endWithError(const std::string& why) {
    say("error: " + why);
    endProcess(failureExitCode);
}

void endProcess(int exitCode) {
    std::fflush(nullptr);
    _exit(exitCode);
}

}  // namespace driver
