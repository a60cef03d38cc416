// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>

#include "laplacian_lines/line_extractor.h"

/// A mesh's levels of laplacian_lines::KernelLevels. Those computed ahead and never used go first,
/// then the least recently used.
class KeptLevels {
public:
    /// Null if it is not there. Valid until add().
    const laplacian_lines::KernelLaplacian* find(int level) const;
    /// For a level that a drawing asked for, not one that stands in for another.
    const laplacian_lines::KernelLaplacian* use(int level);
    bool has(int level) const { return find(level) != nullptr; }
    /// The nearest level that is there; -1 if there is none.
    int nearest(int level) const;
    /// Whether another one fits into `most_bytes` for all.
    bool hasRoom(std::size_t most_bytes) const;
    /// Keeps at most `most_bytes` for all, but always the four last used: what drawings in two
    /// views have.
    void add(int level, laplacian_lines::KernelLaplacian laplacian, std::size_t most_bytes);
    std::size_t bytes() const;

private:
    struct Entry {
        int level;
        laplacian_lines::KernelLaplacian laplacian;
        bool is_used = false;
    };
    /// Never the first one: if it is new, a drawing waits for it.
    void dropOne();

    std::list<Entry> entries_;  ///< the one used last comes first
};
