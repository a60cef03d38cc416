// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>
#include <vector>

#include "prepared_lines.h"

/// Each mesh's last lines, so that switching them off and on computes nothing; the least recently
/// used go, over all documents, when memory is short. GUI thread only.
class KeptLines {
public:
    using Document = const void*;  ///< a name, never followed

    explicit KeptLines(std::size_t most_bytes = usualBytes()) : most_bytes_(most_bytes) {}
    /// A quarter of this machine's memory.
    static std::size_t usualBytes();

    /// The mesh uses these lines alone. Lines that lacked memory are not kept.
    void keep(Document document, int mesh, PreparedLinesPointer lines);
    /// Call it when lines that may be kept have grown.
    void fit();
    /// `alive` are ascending ids.
    void forgetAllBut(Document document, const std::vector<int>& alive);
    /// Frees all, for those who lack memory. False if there was nothing.
    bool drop();

    /// Lines that are shared count once.
    std::size_t bytes() const;

private:
    struct Entry {
        Document document;
        int mesh;
        PreparedLinesPointer lines;
    };

    const std::size_t most_bytes_;
    std::list<Entry> entries_;  ///< the one used last comes first
};
