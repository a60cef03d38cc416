// SPDX-License-Identifier: GPL-3.0-or-later
#include "kept_lines.h"

#include <unistd.h>

#include <algorithm>
#include <set>

std::size_t KeptLines::usualBytes() {
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
    return pages > 0 && page > 0 ? std::size_t(pages) / 4 * std::size_t(page) : 0;
}

void KeptLines::keep(Document document, int mesh, PreparedLinesPointer lines) {
    entries_.remove_if(
        [=](const Entry& entry) { return entry.document == document && entry.mesh == mesh; });
    if (lines->lacked_memory) return;
    entries_.push_front({document, mesh, std::move(lines)});
    fit();
}

void KeptLines::fit() {
    while (bytes() > most_bytes_)
        entries_.pop_back();
}

void KeptLines::forgetAllBut(Document document, const std::vector<int>& alive) {
    entries_.remove_if([&](const Entry& entry) {
        return entry.document == document &&
               !std::binary_search(alive.begin(), alive.end(), entry.mesh);
    });
}

bool KeptLines::drop() {
    const bool has_any = !entries_.empty();
    entries_.clear();
    return has_any;
}

std::size_t KeptLines::bytes() const {
    std::set<const PreparedLines*> counted;
    std::size_t sum = 0;
    for (const Entry& entry : entries_)
        if (counted.insert(entry.lines.get()).second) sum += entry.lines->bytes;
    return sum;
}
