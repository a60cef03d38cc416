// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace laplacian_lines {

/// Asks the system for huge pages in memory that nothing was written to yet: they take fewer page
/// faults, and fewer misses of the tables that find pages. Does nothing for little memory, or where
/// the system has none.
void advise_huge_pages(void* memory, std::size_t bytes);

/// Has pages of much memory that nothing was written to yet cleared on several threads. Otherwise
/// the system clears each when it is first written to, which takes longer than to fill it.
void clear_pages(void* memory, std::size_t bytes);

/// Room in huge pages.
template <class T>
void reserve_large(std::vector<T>& array, std::size_t count) {
    array.reserve(count);
    advise_huge_pages(array.data(), count * sizeof(T));
    clear_pages(array.data(), count * sizeof(T));
}

/// A vector in huge pages, of copies of `value`.
template <class T>
std::vector<T> large_array(std::size_t count, const T& value) {
    std::vector<T> array;
    reserve_large(array, count);
    array.resize(count, value);
    return array;
}

/// The same of elements as their default constructor leaves them.
template <class T>
std::vector<T> large_array(std::size_t count) {
    std::vector<T> array;
    reserve_large(array, count);
    array.resize(count);
    return array;
}

}  // namespace laplacian_lines
