// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/threads.h"

namespace test_meshes {

/// Limits the core's threads while it lives.
class WithThreads {
public:
    explicit WithThreads(int threads) : before_(laplacian_lines::thread_limit()) {
        laplacian_lines::set_thread_limit(threads);
    }
    ~WithThreads() { laplacian_lines::set_thread_limit(before_); }
    WithThreads(const WithThreads&) = delete;
    WithThreads& operator=(const WithThreads&) = delete;

private:
    const int before_;
};

}  // namespace test_meshes
