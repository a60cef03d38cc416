// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "laplacian_lines/error.h"
#include "laplacian_lines/progress.h"
#include "system/thread_pool.h"

namespace laplacian_lines {

class StageProgress {
public:
    StageProgress(const Progress& progress, double begin, double end, const char* name)
        : progress_(progress), begin_(begin), end_(end), name_(name) {}

    /// `done`: 0..1. @throws Error(Cancelled)
    void report(double done) const {
        if (progress_ && !progress_(begin_ + (end_ - begin_) * done, name_))
            throw Error(ErrorCode::Cancelled, "Cancelled; the mesh was not changed.");
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

/// Runs body(i, scratch) for i in [0, count) on several threads, each with its own Scratch, `grain`
/// at a time. The body writes only to what belongs to i, so that the number of threads does not
/// matter. Calls report(n), n growing up to count, from the calling thread; the first exception
/// stops all and is rethrown.
template <class Scratch, class Body, class Report>
void parallel_for(std::size_t count, std::size_t grain, Body body, Report report) {
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
                report(done);
            }
        }
    });
}

/// As a step of a longer computation. Reports its end in any case: the calling thread may have had
/// no part in the work.
template <class Scratch, class Body>
void parallel_for(std::size_t count, const StageProgress& stage, Body body,
                  std::size_t grain = 16) {
    parallel_for<Scratch>(count, grain, body,
                          [&](std::size_t done) { stage.report(double(done) / double(count)); });
    stage.report(1);
}

/// Without reports, one at a time.
template <class Scratch, class Body>
void in_parallel(std::size_t count, Body body) {
    parallel_for<Scratch>(count, 1, body, [](std::size_t) {});
}

struct NoScratch {};

template <class Body>
void in_parallel(std::size_t count, Body body) {
    in_parallel<NoScratch>(count, [&](std::size_t i, NoScratch&) { body(i); });
}

constexpr std::size_t kBlockElements = 8192;

inline std::size_t block_count(std::size_t count) {
    return (count + kBlockElements - 1) / kBlockElements;
}

/// Runs body(begin, end) for blocks of kBlockElements elements of [0, count), for little work per
/// element.
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

/// What find(i, found) appends to `found`, in the order of i.
template <class T, class Find>
std::vector<T> collect(std::size_t count, Find find) {
    std::vector<std::vector<T>> found(block_count(count));
    in_blocks(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            find(std::uint32_t(i), found[begin / kBlockElements]);
    });
    std::vector<T> all;
    for (const auto& of_block : found)
        all.insert(all.end(), of_block.begin(), of_block.end());
    return all;
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

template <class ValueOf>
double sum_of(std::size_t count, ValueOf value_of) {
    const auto sum = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i)
            sum += value_of(i);
        return sum;
    };
    return join_blocks(count, 0., sum, [](double a, double b) { return a + b; });
}

}  // namespace laplacian_lines
