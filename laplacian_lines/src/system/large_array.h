// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace laplacian_lines {

/// Asks for huge pages in memory not yet written to, for fewer page faults and TLB misses. Does
/// nothing for little memory, or where the system has none.
void advise_huge_pages(void* memory, std::size_t bytes);

/// Clears the pages of memory not yet written to on several threads: the system would clear each at
/// its first write, which takes longer than filling it.
void clear_pages(void* memory, std::size_t bytes);

template <class T>
std::vector<T> empty_large_array(std::size_t room) {
    std::vector<T> array;
    array.reserve(room);
    advise_huge_pages(array.data(), room * sizeof(T));
    clear_pages(array.data(), room * sizeof(T));
    return array;
}

template <class T>
std::vector<T> large_array(std::size_t count, const T& value) {
    std::vector<T> array = empty_large_array<T>(count);
    array.resize(count, value);
    return array;
}

/// Default-constructed; numbers are 0.
template <class T>
std::vector<T> large_array(std::size_t count) {
    std::vector<T> array = empty_large_array<T>(count);
    array.resize(count);
    return array;
}

}  // namespace laplacian_lines
