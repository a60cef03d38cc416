// SPDX-License-Identifier: GPL-3.0-or-later
// Threads share the work, nobody waits for absent ones, and errors reach the caller.
#include "system/thread_pool.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "laplacian_lines/error.h"
#include "system/halving.h"
#include "system/parallel.h"
#include "with_threads.h"

namespace {

using namespace laplacian_lines;
using test_meshes::WithThreads;

/// Blocks until another thread opens it; a minute at most, to fail instead of hanging.
class Gate {
public:
    void open() {
        const std::lock_guard<std::mutex> lock(mutex_);
        open_ = true;
        opened_.notify_all();
    }
    bool pass() {
        std::unique_lock<std::mutex> lock(mutex_);
        return opened_.wait_for(lock, std::chrono::minutes(1), [this] { return open_; });
    }

private:
    std::mutex mutex_;
    std::condition_variable opened_;
    bool open_ = false;
};

/// Σ i of [0, count), in blocks of one.
std::size_t shared_sum(std::size_t count) {
    std::vector<std::size_t> done(count, 0);
    in_parallel(count, [&](std::size_t i) { done[i] += i; });
    return std::accumulate(done.begin(), done.end(), std::size_t(0));
}

std::size_t sum(std::size_t count) {
    return count * (count - 1) / 2;
}

TEST(ThreadPool, RunsEachBlockOnceOfManySmallLoops) {
    const WithThreads scope(4);
    for (std::size_t round = 0; round < 2000; ++round)
        ASSERT_EQ(shared_sum(round % 50), sum(round % 50)) << round;
}

TEST(ThreadPool, HelpersJoin) {
    const WithThreads scope(3);
    Gate others[3];
    std::set<unsigned> workers;
    std::mutex mutex;
    // Each block waits until all three are in progress.
    share(3, 3, [&](unsigned worker, Blocks& blocks) {
        for (std::size_t block; blocks.take(block);) {
            others[block].open();
            for (Gate& gate : others)
                EXPECT_TRUE(gate.pass());
            const std::lock_guard<std::mutex> lock(mutex);
            workers.insert(worker);
        }
    });
    EXPECT_EQ(workers, (std::set<unsigned>{0, 1, 2}));
}

TEST(ThreadPool, UsesNoMoreThreadsThanTheLimit) {
    for (const int limit : {1, 2, 5}) {
        const WithThreads scope(limit);
        EXPECT_EQ(workers_for(1000), unsigned(limit));
        EXPECT_EQ(workers_for(2), unsigned(std::min(limit, 2)));
        EXPECT_EQ(workers_for(0), 1u);
        std::set<std::thread::id> threads;
        std::mutex mutex;
        in_parallel(1000, [&](std::size_t) {
            const std::lock_guard<std::mutex> lock(mutex);
            threads.insert(std::this_thread::get_id());
        });
        EXPECT_LE(threads.size(), std::size_t(limit));
    }
    set_thread_limit(0);
    EXPECT_GE(thread_limit(), 1);
}

/// A stuck helper in its own block; the caller does all others.
TEST(ThreadPool, DoesTheRestWhileAHelperIsHeldUp) {
    const WithThreads scope(2);
    Gate held, rest_done;
    std::size_t by_caller = 0;
    share(100, 2, [&](unsigned worker, Blocks& blocks) {
        if (worker == 0) {
            EXPECT_TRUE(held.pass());
        }
        for (std::size_t block; blocks.take(block);) {
            if (worker == 0) {
                if (++by_caller == 99) rest_done.open();
                continue;
            }
            held.open();
            EXPECT_TRUE(rest_done.pass());
        }
    });
    EXPECT_EQ(by_caller, 99u);
}

/// All helpers are stuck elsewhere and never join.
TEST(ThreadPool, WaitsForNoHelperThatHasNotBegun) {
    const WithThreads scope(2);
    Gate held, other_done;
    std::thread other([&] {
        share(2, 2, [&](unsigned, Blocks& blocks) {
            for (std::size_t block; blocks.take(block);) {
                if (block == 1) held.open();
                EXPECT_TRUE(other_done.pass());
            }
        });
    });
    EXPECT_TRUE(held.pass());
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(shared_sum(50), sum(50));
    other_done.open();
    other.join();
}

TEST(ThreadPool, LoopsOfManyThreadsAtOnceShareIt) {
    const WithThreads scope(3);
    std::atomic<int> wrong{0};
    std::vector<std::thread> callers;
    for (std::size_t caller = 0; caller < 4; ++caller)
        callers.emplace_back([&, caller] {
            for (std::size_t round = 0; round < 500; ++round)
                wrong += shared_sum(caller + round % 30) != sum(caller + round % 30);
        });
    for (std::thread& caller : callers)
        caller.join();
    EXPECT_EQ(wrong, 0);
}

TEST(ThreadPool, LoopsWithinLoops) {
    const WithThreads scope(4);
    for (int round = 0; round < 20; ++round) {
        std::vector<std::size_t> sums(30);
        in_parallel(sums.size(), [&](std::size_t i) {
            in_parallel(3, [&](std::size_t) { shared_sum(5); });
            sums[i] = shared_sum(20 + i);
        });
        for (std::size_t i = 0; i < sums.size(); ++i)
            EXPECT_EQ(sums[i], sum(20 + i));
    }
}

TEST(ThreadPool, ThrowsAgainWhatABlockThrows) {
    for (const int threads : {1, 4}) {
        const WithThreads scope(threads);
        for (std::size_t bad = 0; bad < 100; bad += 7) {
            const auto fail_at_bad = [&](std::size_t i) {
                if (i == bad) throw std::runtime_error(std::to_string(i));
            };
            try {
                in_parallel(100, fail_at_bad);
                ADD_FAILURE() << "no error";
            } catch (const std::runtime_error& error) {
                EXPECT_EQ(error.what(), std::to_string(bad));
            }
            EXPECT_EQ(shared_sum(100), sum(100));
        }
    }
}

TEST(ThreadPool, AnErrorOfAHelperEndsTheLoop) {
    const WithThreads scope(2);
    Gate has_joined;
    constexpr std::size_t kEndless = std::size_t(1) << 62;
    const auto work = [&](unsigned worker, Blocks& blocks) {
        if (worker == 1) {
            has_joined.open();
            throw std::bad_alloc();
        }
        EXPECT_TRUE(has_joined.pass());
        for (std::size_t block; blocks.take(block);) {
        }
    };
    EXPECT_THROW(share(kEndless, 2, work), std::bad_alloc);
}

TEST(ThreadPool, ProgressComesFromTheCallerAndCancels) {
    const WithThreads scope(3);
    const std::thread::id caller = std::this_thread::get_id();
    int calls = 0;
    const Progress progress = [&](double, const char*) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        return ++calls < 3;
    };
    const StageProgress stage(progress, 0, 1, "counting");
    std::atomic<std::size_t> done{0};
    const auto count = [&](std::size_t, NoScratch&) { ++done; };
    try {
        while (calls < 3)
            parallel_for<NoScratch>(1'000'000, stage, count, 1);
        ADD_FAILURE() << "not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    }
    EXPECT_EQ(calls, 3);
    const std::size_t before = done;
    std::this_thread::yield();
    EXPECT_EQ(done, before);  // nobody goes on
}

struct Interval {
    std::size_t begin = 0, end = 0;
    std::size_t size() const { return end - begin; }
};

TEST(ThreadPool, HalvesMakeAHeapOfTheWhole) {
    const auto cut = [](const Interval& i) {
        const std::size_t middle = i.begin + i.size() / 2;
        return std::pair(Interval{i.begin, middle}, Interval{middle, i.end});
    };
    for (const int threads : {1, 2, 8})
        for (const std::size_t size : {1u, 10u, 11u, 1000u}) {
            const WithThreads scope(threads);
            const std::vector<Interval> parts = halve_in_parallel(Interval{0, size}, 10, cut);
            ASSERT_EQ(parts.size() % 2, 1u);
            EXPECT_EQ(parts.size() > 1, threads > 1 && size > 10);
            std::size_t end = 0;
            for (std::size_t i = 0; i < parts.size(); ++i) {
                if (i < parts.size() / 2) {
                    EXPECT_EQ(parts[i].begin, parts[2 * i + 1].begin);
                    EXPECT_EQ(parts[2 * i + 1].end, parts[2 * i + 2].begin);
                    EXPECT_EQ(parts[i].end, parts[2 * i + 2].end);
                } else {
                    EXPECT_EQ(parts[i].begin, end);
                    end = parts[i].end;
                }
            }
            EXPECT_EQ(end, size);
        }
}

/// As Python's multiprocessing does: the child has no threads.
TEST(ThreadPool, GoesOnInAForkedProcess) {
    const WithThreads scope(3);
    ASSERT_EQ(shared_sum(100), sum(100));
    std::atomic<bool> ends{false};
    std::thread busy([&] {  // so that the pool is in use when the process is forked
        while (!ends)
            shared_sum(50);
    });
    for (int round = 0; round < 20; ++round) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            alarm(60);
            std::size_t right = 0;
            for (std::size_t i = 0; i < 100; ++i)
                right += shared_sum(i) == sum(i);
            _exit(right == 100 ? 0 : 1);
        }
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        EXPECT_EQ(status, 0) << round;
    }
    ends = true;
    busy.join();
}

}  // namespace
