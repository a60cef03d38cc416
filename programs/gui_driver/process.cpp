// SPDX-License-Identifier: GPL-3.0-or-later
#include "process.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>

// The leak sanitizer's, only with sanitized plugins.
extern "C" int __lsan_do_recoverable_leak_check() __attribute__((weak));

namespace driver {
namespace {

// Made beforehand: a signal's handler may neither allocate nor lock.
char timeout_message[4096];
unsigned watched_seconds = 0;

void end_by_alarm(int) {
    [[maybe_unused]] const auto written =
        write(STDERR_FILENO, timeout_message, std::strlen(timeout_message));
    _exit(kFailureExitCode);
}

}  // namespace

void say(const std::string& text) {
    std::fprintf(stderr, "meshlab_driver: %s\n", text.c_str());
    std::fflush(stderr);
}

void end_with_error(const std::string& why) {
    say("error: " + why);
    end_process(kFailureExitCode);
}

void end_process(int exit_code) {
    alarm(0);  // looking for leaks takes as long as it takes
    std::fflush(nullptr);
    if (__lsan_do_recoverable_leak_check) __lsan_do_recoverable_leak_check();
    _exit(exit_code);
}

void watch(const std::string& what, unsigned seconds) {
    alarm(0);
    std::snprintf(timeout_message, sizeof timeout_message,
                  "meshlab_driver: error: %s: time-out after %u s\n", what.c_str(), seconds);
    std::signal(SIGALRM, end_by_alarm);
    watched_seconds = seconds;
    restart_watch();
}

void restart_watch() {
    alarm(watched_seconds);
}

}  // namespace driver
