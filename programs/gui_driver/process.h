// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace driver {

constexpr int failure_exit_code = 3;

void say(const std::string& text);                       // one line on stderr
[[noreturn]] void endWithError(const std::string& why);  // from any thread
[[noreturn]] void endProcess(int exitCode);  // at once: no "save changes?" box, no teardown

// Ends the process when a script line takes too long, or MeshLab shows no progress for as long. On
// its own thread: a GUI timer never fires while a filter or drawing hangs. Time while the machine
// is suspended does not count.
class Watchdog {
public:
    explicit Watchdog(std::chrono::milliseconds limit);
    ~Watchdog();

    void setLimit(std::chrono::milliseconds limit);
    void watch(const std::string& what);  // restarts the clock
    void progress();                      // restarts it, too
    void rest();                          // nothing to watch

private:
    void run();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::chrono::milliseconds limit_;
    std::chrono::milliseconds spent_{0};
    std::string what_;
    bool watching_ = false;
    bool ending_ = false;
    std::thread thread_;  // last: starts when all else is ready
};

}  // namespace driver
