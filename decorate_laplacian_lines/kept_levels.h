// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>

#include "laplacian_lines/line_extractor.h"

/// The levels of a mesh that are there, of laplacian_lines::KernelLevels. Those computed ahead that
/// no drawing has used go first, then those used longest ago.
class KeptLevels {
public:
    /// Null if it is not there. Valid until the next call of add().
    const laplacian_lines::KernelLaplacian* find(int level) const;
    /// The same of a level that a drawing wants; one that stands in for another does not count.
    const laplacian_lines::KernelLaplacian* use(int level);
    bool has(int level) const { return find(level) != nullptr; }
    /// The level that is there and nearest to this one; -1 if there is none.
    int nearest(int level) const;
    /// Whether another one will fit into `most_bytes` of all.
    bool hasRoom(std::size_t most_bytes) const;
    /// Keeps no more than `most_bytes` of all, but the four that were used last: what drawings in
    /// two views have.
    void add(int level, laplacian_lines::KernelLaplacian laplacian, std::size_t most_bytes);
    std::size_t bytes() const;

private:
    struct Entry {
        int level;
        laplacian_lines::KernelLaplacian laplacian;
        bool is_used = false;
    };
    /// Never the first one: where it has just been added, a drawing waits for it.
    void dropOne();

    std::list<Entry> entries_;  ///< the one used last comes first
};
