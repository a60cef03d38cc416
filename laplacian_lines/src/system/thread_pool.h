// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace laplacian_lines {

/// The blocks of a loop, which the threads that share it take in their order.
class Blocks {
public:
    explicit Blocks(std::size_t count) : count_(count) {}

    /// False if none is left.
    bool take(std::size_t& block) {
        block = next_.fetch_add(1, std::memory_order_relaxed);
        return block < count_;
    }
    bool any_left() const { return next_.load(std::memory_order_relaxed) < count_; }
    /// Leaves none.
    void stop() { next_.store(count_, std::memory_order_relaxed); }

private:
    const std::size_t count_;
    std::atomic<std::size_t> next_{0};
};

/// What a thread does for a loop: it takes blocks until none is left. `worker` is 0 in the calling
/// thread; those that join have the next numbers.
using SharedWork = std::function<void(unsigned worker, Blocks& blocks)>;

void share_work(std::size_t blocks, unsigned workers, const SharedWork& work);

/// Runs `work` in the calling thread and, at the same time, in threads of the pool that are idle:
/// `workers` threads at most. Whoever joins late gets what is left, so that the caller waits for
/// nobody but those that are in the middle of a block. The first exception leaves no blocks to the
/// others and is thrown again here. Work may share loops of its own. Thread-safe.
template <class Work>
void share(std::size_t blocks, unsigned workers, Work work) {
    share_work(blocks, workers, std::ref(work));
}

/// How many threads are worth their while for so many blocks; at least 1.
unsigned workers_for(std::size_t blocks);

}  // namespace laplacian_lines
