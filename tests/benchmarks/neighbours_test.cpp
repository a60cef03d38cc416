// SPDX-License-Identifier: GPL-3.0-or-later
#include "speed/neighbours.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <thread>

namespace {

using namespace benchmarks;

/// Clock ticks of this process's children.
std::map<int, long> times_of_children() {
    std::map<int, long> times;
    std::ifstream children("/proc/thread-self/children");
    for (int process = 0; children >> process;) {
        std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
        stat.ignore(std::numeric_limits<std::streamsize>::max(), ')');  // its name may have blanks
        std::string skipped;
        for (int i = 0; i < 11; ++i)
            stat >> skipped;
        long user = 0, system = 0;
        stat >> user >> system;
        times[process] = user + system;
    }
    return times;
}

/// Waits until some have run.
std::size_t count_of_working() {
    const std::map<int, long> before = times_of_children();
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    std::size_t working = 0;
    for (const auto& [process, time] : times_of_children())
        working += time > before.at(process);
    return working;
}

TEST(Neighbours, WorkWhenTheyAreAskedToAndAreGoneAfterwards) {
    const std::size_t cores = std::thread::hardware_concurrency();
    {
        const Neighbours neighbours;
        EXPECT_EQ(times_of_children().size(), 1 + cores);
        EXPECT_EQ(count_of_working(), 0u);
        neighbours.set(Load::Stream);
        EXPECT_EQ(count_of_working(), 1u);
        neighbours.set(Load::Cores);
        EXPECT_EQ(count_of_working(), cores - 1);
        neighbours.set(Load::AllCores);
        EXPECT_EQ(count_of_working(), cores);
        neighbours.set(Load::Quiet);
        EXPECT_EQ(count_of_working(), 0u);
    }
    EXPECT_TRUE(times_of_children().empty());
}

}  // namespace
