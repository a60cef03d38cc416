// SPDX-License-Identifier: GPL-3.0-or-later
#include "allocation_hook.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

constexpr long kNever = -1;
std::atomic<std::size_t> calls{0};
std::atomic<long> calls_left{kNever};  // until one fails
std::atomic<bool> has_failed{false};

void count_call() {
    ++calls;
    if (calls_left == kNever) return;
    if (calls_left.fetch_sub(1) != 0) return;
    calls_left = kNever;
    has_failed = true;
    throw std::bad_alloc();
}

void* allocate(std::size_t size) {
    return std::malloc(size ? size : 1);
}

void* checked(void* memory) {
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

namespace allocation_hook {

std::size_t count() {
    return calls;
}

void fail_after(long left) {
    has_failed = false;
    calls_left = left;
}

bool stop_failing() {
    calls_left = kNever;
    return has_failed;
}

}  // namespace allocation_hook

void* operator new(std::size_t size) {
    count_call();
    return checked(allocate(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    count_call();
    const std::size_t step = static_cast<std::size_t>(alignment);
    return checked(std::aligned_alloc(step, (size + step - 1) / step * step));
}
// Callers of this one go on without memory, so a failure would not show.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++calls;
    return allocate(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
