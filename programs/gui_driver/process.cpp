// SPDX-License-Identifier: GPL-3.0-or-later
#include "process.h"
#include <unistd.h>
#include <cstdio>

// The leak sanitizer's, only with sanitized plugins.
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

Watchdog::Watchdog(std::chrono::milliseconds limit) : limit_(limit), thread_([this] { run(); }) {}

Watchdog::~Watchdog() {
    {
        std::lock_guard<std::mutex> lock(mutex_);
        ending_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void Watchdog::setLimit(std::chrono::milliseconds limit) {
    std::lock_guard<std::mutex> lock(mutex_);
    limit_ = limit;
}

void Watchdog::watch(const std::string& what) {
    {
        std::lock_guard<std::mutex> lock(mutex_);
        what_ = what;
        spent_ = {};
        watching_ = true;
    }
    changed_.notify_one();
}

void Watchdog::progress() {
    std::lock_guard<std::mutex> lock(mutex_);
    spent_ = {};
}

void Watchdog::rest() {
    std::lock_guard<std::mutex> lock(mutex_);
    watching_ = false;
}

void Watchdog::run() {
    constexpr std::chrono::milliseconds look(50);
    std::unique_lock<std::mutex> lock(mutex_);
    while (!ending_) {
        if (!watching_) {
            changed_.wait(lock);
        } else if (changed_.wait_for(lock, look) == std::cv_status::timeout && watching_) {
            spent_ += look;  // however long it took until this thread could look
            if (spent_ >= limit_)
                endWithError(what_ + ": time-out after " + std::to_string(limit_.count() / 1000.) +
                             " s");
        }
    }
}

}  // namespace driver
