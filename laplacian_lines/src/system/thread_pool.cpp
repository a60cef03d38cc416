// SPDX-License-Identifier: GPL-3.0-or-later
// Threads that help with loops. Who runs a loop lists it as open, wakes helpers, and works on it
// itself; helpers join the first open loop that has room, and take blocks until none is left. The
// runner leaves when all helpers have. Loops within loops are just more open loops.
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <new>
#include <thread>
#include <vector>

#include "system/parallel.h"

#ifdef __linux__
#include <sched.h>
#endif
#ifdef __unix__
#include <pthread.h>
#endif

namespace laplacian_lines {
namespace {

constexpr int kSpinsBeforeSleep = 2000;  // some microseconds, in which a short block ends
constexpr unsigned kWakeAtOnce = 2;      // these wake the others
// wait(lock) without a time would need a newer libstdc++ than MeshLab's.
constexpr std::chrono::hours kLongest{24};

/// A loop that threads share, in the memory of the one that runs it.
struct Loop {
    Loop(std::size_t count, unsigned workers, const SharedWork& loop_work)
        : blocks(count), work(loop_work), most_helpers(workers - 1) {}

    bool has_room() const { return helpers < most_helpers; }

    Blocks blocks;
    const SharedWork& work;
    const unsigned most_helpers;
    // Changed under the pool's lock.
    unsigned helpers = 0;             // that have joined
    std::atomic<unsigned> inside{0};  // helpers that have not left
    std::exception_ptr failure;
    Loop* next = nullptr;  // in the list of open ones
};

class Pool {
public:
    /// Helpers must not outlive their code, which may be a plugin's.
    ~Pool() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            ending_ = true;
        }
        wake_.notify_all();
        for (std::thread& thread : threads_)
            thread.join();
    }

    void run(Loop& loop) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            start_threads(loop.most_helpers);
            loop.next = open_;
            open_ = &loop;
        }
        wake(loop.most_helpers);
        work_on(loop, 0);
        for (int i = 0; loop.inside != 0 && i < kSpinsBeforeSleep; ++i) {
        }
        std::unique_lock<std::mutex> lock(mutex_);
        close(loop);
        while (!left_.wait_for(lock, kLongest, [&] { return loop.inside == 0; })) {
        }
    }

private:
    /// Starts fewer if there is no memory for another stack.
    void start_threads(unsigned count) {
        try {
            while (threads_.size() < count && !ending_)
                threads_.emplace_back([this] { help(); });
        } catch (const std::exception&) {
        }
    }

    void wake(unsigned helpers) {
        for (unsigned i = 0; i < std::min(helpers, kWakeAtOnce); ++i)
            wake_.notify_one();
    }

    void help() {
        std::unique_lock<std::mutex> lock(mutex_);
        while (!ending_) {
            Loop* loop = open_;
            while (loop && !loop->has_room())
                loop = loop->next;
            if (!loop) {
                wake_.wait_for(lock, kLongest);
                continue;
            }
            ++loop->inside;
            const unsigned worker = ++loop->helpers, missing = loop->most_helpers - worker;
            lock.unlock();
            if (loop->blocks.any_left()) wake(missing);
            work_on(*loop, worker);
            lock.lock();
            close(*loop);  // it has no blocks left
            if (--loop->inside == 0) left_.notify_all();
        }
    }

    void work_on(Loop& loop, unsigned worker) {
        try {
            loop.work(worker, loop.blocks);
        } catch (...) {
            loop.blocks.stop();
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!loop.failure) loop.failure = std::current_exception();
        }
    }

    void close(const Loop& loop) {
        Loop** place = &open_;
        while (*place && *place != &loop)
            place = &(*place)->next;
        if (*place) *place = loop.next;
    }

    std::mutex mutex_;
    std::condition_variable wake_, left_;
    std::vector<std::thread> threads_;
    Loop* open_ = nullptr;  // the loops that can be joined, the last one first
    bool ending_ = false;
};

Pool& pool() {
    static Pool pool;
#ifdef __unix__
    // A forked process has none of the threads, and perhaps a locked mutex: it starts over.
    static const int prepared =
        pthread_atfork(nullptr, nullptr, [] { new (static_cast<void*>(&pool)) Pool; });
    (void)prepared;
#endif
    return pool;
}

int processor_count() {
#ifdef __linux__
    cpu_set_t processors;
    if (sched_getaffinity(0, sizeof processors, &processors) == 0) return CPU_COUNT(&processors);
#endif
    return std::max(1, int(std::thread::hardware_concurrency()));
}

int first_limit() {
    const char* const wanted = std::getenv("LAPLACIAN_LINES_THREADS");
    const int threads = wanted ? std::atoi(wanted) : 0;
    return threads > 0 ? threads : processor_count();
}

std::atomic<int> limit{0};  // less than 1: that of first_limit()

}  // namespace

int thread_limit() {
    static const int first = first_limit();
    const int set = limit;
    return set > 0 ? set : first;
}

void set_thread_limit(int threads) {
    limit = threads;
}

unsigned workers_for(std::size_t blocks) {
    return unsigned(std::clamp<std::size_t>(blocks, 1, std::size_t(thread_limit())));
}

void share_work(std::size_t blocks, unsigned workers, const SharedWork& work) {
    Loop loop(blocks, workers, work);
    if (workers == 1) return work(0, loop.blocks);
    pool().run(loop);
    if (loop.failure) std::rethrow_exception(loop.failure);
}

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& body) {
    share(count, workers_for(count), [&](unsigned, Blocks& shared) {
        for (std::size_t i; shared.take(i);)
            body(i);
    });
}

}  // namespace laplacian_lines
