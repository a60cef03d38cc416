// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>
#include <vector>

#include "prepared_lines.h"

/// The lines that each mesh had last, so that switching them off and on computes nothing. Of all
/// documents together only so many bytes: what was used longest ago goes first. GUI thread only.
class KeptLines {
public:
    using Document = const void*;  ///< a name, never followed

    explicit KeptLines(std::size_t most_bytes = usualBytes()) : most_bytes_(most_bytes) {}
    /// A quarter of this machine's memory.
    static std::size_t usualBytes();

    /// The mesh uses these lines now and no others. Those that lacked memory are not kept.
    void keep(Document document, int mesh, PreparedLinesPointer lines);
    /// To be called when lines that may be kept have grown.
    void fit();
    /// Meshes of the document that are not in `alive` (ascending ids) are gone.
    void forgetAllBut(Document document, const std::vector<int>& alive);
    /// Gives all back, for those who lack memory. False if there is nothing.
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
