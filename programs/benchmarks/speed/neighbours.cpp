// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace benchmarks {
namespace {

constexpr std::chrono::milliseconds kUntilItShows(50);

[[noreturn]] void copy_memory() {
    constexpr std::size_t bytes = 256u << 20;
    std::vector<char> from(bytes, 1), to(bytes);
    for (volatile const char* seen = to.data();; static_cast<void>(*seen))
        std::memcpy(to.data(), from.data(), bytes);
}

[[noreturn]] void compute() {
    for (volatile std::uint64_t number = 0;;)
        number = number + 1;
}

void signal_all(const std::vector<pid_t>& group, int signal) {
    for (const pid_t process : group)
        kill(process, signal);
}

}  // namespace

Neighbours::Neighbours() {
    try {
        start(stream_, [] { copy_memory(); });
        for (unsigned core = 0; core < std::thread::hardware_concurrency(); ++core)
            start(cores_, [] { compute(); });
    } catch (...) {
        end();
        throw;
    }
    set(Load::Quiet);
}

Neighbours::~Neighbours() {
    end();
}

void Neighbours::start(std::vector<pid_t>& group, void (*work)()) {
    const pid_t process = fork();
    if (process < 0) throw std::runtime_error("no process can be started beside the measurement");
    if (process == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        work();
    }
    group.push_back(process);
}

void Neighbours::end() const {
    for (const auto& group : {stream_, cores_}) {
        signal_all(group, SIGKILL);
        for (const pid_t process : group)
            waitpid(process, nullptr, 0);
    }
}

void Neighbours::set(Load load) const {
    signal_all(stream_, load == Load::Stream ? SIGCONT : SIGSTOP);
    signal_all(cores_, load == Load::Cores || load == Load::AllCores ? SIGCONT : SIGSTOP);
    if (load == Load::Cores) signal_all({cores_.front()}, SIGSTOP);
    std::this_thread::sleep_for(kUntilItShows);
}

}  // namespace benchmarks
