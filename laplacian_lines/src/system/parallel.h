// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <tuple>
#include <vector>

#include "laplacian_lines/progress.h"
#include "laplacian_lines/threads.h"

namespace laplacian_lines {

/// Progress of a stage of a call, which takes from `begin` to `end` of the whole, 0..1. `progress`
/// and `name` outlive it.
class StageProgress {
public:
    StageProgress(const Progress& progress, double begin, double end, const char* name)
        : progress_(progress), begin_(begin), end_(end), name_(name) {}

    /// `done`: 0..1. @throws Error(Cancelled)
    void report(double done) const {
        laplacian_lines::report(progress_, begin_ + (end_ - begin_) * done, name_);
    }

    StageProgress part(double begin, double end) const {
        const double size = end_ - begin_;
        return {progress_, begin_ + begin * size, begin_ + end * size, name_};
    }

private:
    const Progress& progress_;
    double begin_, end_;
    const char* name_;
};

/// The blocks of a loop, which its threads take in order.
class Blocks {
public:
    explicit Blocks(std::size_t count) : count_(count) {}

    bool take(std::size_t& block) {
        block = next_.fetch_add(1, std::memory_order_relaxed);
        return block < count_;
    }
    bool any_left() const { return next_.load(std::memory_order_relaxed) < count_; }
    void stop() { next_.store(count_, std::memory_order_relaxed); }

private:
    const std::size_t count_;
    std::atomic<std::size_t> next_{0};
};

/// Takes blocks until none is left. `worker`: 0 in the calling thread, 1.. in those that join.
using SharedWork = std::function<void(unsigned worker, Blocks& blocks)>;

void share_work(std::size_t blocks, unsigned workers, const SharedWork& work);

/// Runs `work` in the calling thread and in idle threads of the pool, `workers` in all at most.
/// Late ones get what is left: the caller only waits for blocks in progress. The first exception
/// discards the blocks that are left and is rethrown. Work may share loops of its own. Thread-safe.
template <class Work>
void share(std::size_t blocks, unsigned workers, Work work) {
    share_work(blocks, workers, std::ref(work));
}

/// Useful number of threads for so many blocks, at least 1.
unsigned workers_for(std::size_t blocks);

/// As in_parallel() of threads.h, but body(i, scratch), each thread with a Scratch of its own.
template <class Scratch, class Body>
void in_parallel(std::size_t count, Body body) {
    share(count, workers_for(count), [&](unsigned, Blocks& shared) {
        Scratch scratch;
        for (std::size_t i; shared.take(i);)
            body(i, scratch);
    });
}

struct NoScratch {};

/// The same for a step of a longer computation, `grain` numbers i at a time. Reports progress from
/// the calling thread, and the end in any case, since that thread may have had no part in the work.
template <class Scratch, class Body>
void parallel_for(std::size_t count, const StageProgress& stage, Body body,
                  std::size_t grain = 16) {
    std::atomic<std::size_t> finished{0};
    const std::size_t report_every = std::max<std::size_t>(1, count / 100);
    const std::size_t blocks = (count + grain - 1) / grain;
    share(blocks, workers_for(blocks), [&](unsigned worker, Blocks& shared) {
        Scratch scratch;
        std::size_t next_report = 0;
        for (std::size_t block; shared.take(block);) {
            const std::size_t begin = block * grain, end = std::min(count, begin + grain);
            for (std::size_t i = begin; i < end; ++i)
                body(i, scratch);
            const std::size_t done = finished.fetch_add(end - begin, std::memory_order_relaxed);
            if (worker == 0 && done >= next_report) {
                next_report = done + report_every;
                stage.report(double(done) / double(count));
            }
        }
    });
    stage.report(1);
}

/// Elements that a thread takes at once where each is little work.
constexpr std::size_t kBlockElements = 8192;

inline std::size_t block_count(std::size_t count) {
    return (count + kBlockElements - 1) / kBlockElements;
}

/// Runs body(begin, end) for blocks of kBlockElements elements of [0, count).
template <class Body>
void in_blocks(std::size_t count, Body body) {
    in_parallel(block_count(count), [&](std::size_t i) {
        body(i * kBlockElements, std::min(count, (i + 1) * kBlockElements));
    });
}

template <class Body>
void for_each_element(std::size_t count, Body body) {
    in_blocks(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            body(i);
    });
}

template <class T>
std::vector<T> concatenate(const std::vector<std::vector<T>>& parts) {
    std::vector<T> all;
    for (const std::vector<T>& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// What find(i, found) appends to `found`, in the order of i; `grain` of them at a time.
template <class T, class Find>
std::vector<T> collect(std::size_t count, Find find, std::size_t grain = kBlockElements) {
    std::vector<std::vector<T>> found((count + grain - 1) / grain);
    in_parallel(found.size(), [&](std::size_t block) {
        for (std::size_t i = block * grain; i < std::min(count, (block + 1) * grain); ++i)
            find(std::uint32_t(i), found[block]);
    });
    return concatenate(found);
}

/// Those below `count` for which test(number), ascending.
template <class Test>
std::vector<std::uint32_t> numbers_where(std::size_t count, Test test) {
    return collect<std::uint32_t>(count, [&](std::uint32_t number, auto& found) {
        if (test(number)) found.push_back(number);
    });
}

inline std::vector<std::uint32_t> numbers_up_to(std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

/// The elements for which keep(number), in their order.
template <class T, class Keep>
std::vector<T> kept(const std::vector<T>& all, Keep keep) {
    return collect<T>(all.size(), [&](std::uint32_t number, std::vector<T>& kept) {
        if (keep(number)) kept.push_back(all[number]);
    });
}

/// Joins value(begin, end) of the blocks to `start` in order, so that the number of threads does
/// not matter.
template <class T, class Value, class Join>
T join_blocks(std::size_t count, T start, Value value, Join join) {
    std::vector<T> values(block_count(count));
    in_blocks(count, [&](std::size_t begin, std::size_t end) {
        values[begin / kBlockElements] = value(begin, end);
    });
    for (const T& of_block : values)
        start = join(start, of_block);
    return start;
}

template <class Number = double, class ValueOf>
Number sum_of(std::size_t count, ValueOf value_of) {
    const auto sum_of_block = [&](std::size_t begin, std::size_t end) {
        Number sum = 0;
        for (std::size_t i = begin; i < end; ++i)
            sum += value_of(i);
        return sum;
    };
    return join_blocks(count, Number(0), sum_of_block, std::plus<>());
}

/// Halves `whole` recursively, each level in parallel, until all threads have a share or parts are
/// `small`. cut(part) returns a pair of about equal sizes and writes only to what belongs to its
/// part. The result is a heap: the first size / 2 parts are cut, part i into 2i + 1 and 2i + 2. The
/// number of threads only decides on the number of levels.
template <class Part, class Cut>
std::vector<Part> halve_in_parallel(const Part& whole, std::size_t small, Cut cut) {
    const auto threads = std::size_t(thread_limit());
    const std::size_t enough = threads > 1 ? 8 * threads : 1;
    std::vector<Part> parts = {whole};
    for (std::size_t level = 0; parts.size() - level < enough && parts[level].size() > small;) {
        const std::size_t next = parts.size();
        parts.resize(2 * next + 1);
        in_parallel(next - level, [&](std::size_t i) {
            std::tie(parts[next + 2 * i], parts[next + 2 * i + 1]) = cut(parts[level + i]);
        });
        level = next;
    }
    return parts;
}

}  // namespace laplacian_lines
