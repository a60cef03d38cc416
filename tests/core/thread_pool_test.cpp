// SPDX-License-Identifier: GPL-3.0-or-later
// The core's threads: callers share them, what callbacks throw comes back, and a forked process
// goes on without them. That results do not depend on them: determinism_test.cpp.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "helpers.h"
#include "laplacian_lines/precompute.h"
#include "with_threads.h"

namespace {

using namespace laplacian_lines;
using test_meshes::WithThreads;

const TriangleMesh& mesh() {
    return test_meshes::mesh_named("torus_jittered").mesh;
}

TEST(ThreadPool, HaveALimit) {
    const WithThreads scope(5);
    EXPECT_EQ(thread_limit(), 5);
    set_thread_limit(0);
    EXPECT_GE(thread_limit(), 1);
}

TEST(ThreadPool, AreSharedByCallersAtOnce) {
    const WithThreads scope(4);
    const Field expected = precompute(mesh());
    std::atomic<int> different{0};
    std::vector<std::thread> callers;
    for (int caller = 0; caller < 4; ++caller)
        callers.emplace_back([&] {
            for (int round = 0; round < 3; ++round)
                different += !helpers::same_fields(precompute(mesh()), expected);
        });
    for (std::thread& caller : callers)
        caller.join();
    EXPECT_EQ(different, 0);
}

/// Callbacks run in the caller's thread alone.
TEST(ThreadPool, PassOnWhatCallbacksThrow) {
    const WithThreads scope(4);
    const std::thread::id caller = std::this_thread::get_id();
    for (const double moment : {0., 0.3, 0.9})
        EXPECT_THROW(precompute(mesh(), {},
                                [&](double done, const char*) {
                                    EXPECT_EQ(std::this_thread::get_id(), caller);
                                    if (done >= moment) throw std::runtime_error("enough");
                                    return true;
                                }),
                     std::runtime_error);
}

/// As Python's multiprocessing does: the child has no threads.
TEST(ThreadPool, AreStartedAgainInAForkedProcess) {
    const WithThreads scope(3);
    const Field expected = precompute(mesh());
    std::atomic<bool> ends{false};
    std::thread busy([&] {  // so that the pool is in use when the process is forked
        while (!ends)
            precompute(mesh());
    });
    for (int round = 0; round < 5; ++round) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            alarm(60);
            _exit(helpers::same_fields(precompute(mesh()), expected) ? 0 : 1);
        }
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        EXPECT_EQ(status, 0) << round;
    }
    ends = true;
    busy.join();
}

}  // namespace
