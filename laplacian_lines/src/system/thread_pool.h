// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace laplacian_lines {

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

/// Takes blocks until none is left. `worker` is 0 in the calling thread, 1.. in those that join.
using SharedWork = std::function<void(unsigned worker, Blocks& blocks)>;

void share_work(std::size_t blocks, unsigned workers, const SharedWork& work);

/// Runs `work` in the calling thread and in idle threads of the pool, `workers` at most. Late ones
/// get what is left: the caller only waits for blocks in progress. The first exception discards the
/// blocks that are left and is rethrown. Work may share loops of its own. Thread-safe.
template <class Work>
void share(std::size_t blocks, unsigned workers, Work work) {
    share_work(blocks, workers, std::ref(work));
}

/// Threads that pay for so many blocks, at least 1.
unsigned workers_for(std::size_t blocks);

}  // namespace laplacian_lines
