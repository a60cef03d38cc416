// SPDX-License-Identifier: GPL-3.0-or-later
#include "kept_levels.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <numeric>

namespace {

constexpr std::size_t least_count = 4;

}  // namespace

const laplacian_lines::KernelLaplacian* KeptLevels::find(int level) const {
    for (const Entry& entry : entries_)
        if (entry.level == level) return &entry.laplacian;
    return nullptr;
}

const laplacian_lines::KernelLaplacian* KeptLevels::use(int level) {
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [=](const Entry& entry) { return entry.level == level; });
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    found->is_used = true;
    return &found->laplacian;
}

int KeptLevels::nearest(int level) const {
    const auto found =
        std::min_element(entries_.begin(), entries_.end(), [=](const Entry& a, const Entry& b) {
            return std::abs(a.level - level) < std::abs(b.level - level);
        });
    return found == entries_.end() ? -1 : found->level;
}

bool KeptLevels::hasRoom(std::size_t most_bytes) const {
    return entries_.empty() || bytes() + entries_.front().laplacian.memory() <= most_bytes;
}

void KeptLevels::add(int level, laplacian_lines::KernelLaplacian laplacian,
                     std::size_t most_bytes) {
    entries_.remove_if([=](const Entry& entry) { return entry.level == level; });
    entries_.push_front({level, std::move(laplacian)});
    while (entries_.size() > least_count && bytes() > most_bytes)
        dropOne();
}

void KeptLevels::dropOne() {
    auto dropped = std::prev(entries_.end());
    for (auto entry = std::next(entries_.begin()); entry != entries_.end(); ++entry)
        if (!entry->is_used) dropped = entry;
    entries_.erase(dropped);
}

std::size_t KeptLevels::bytes() const {
    return std::accumulate(
        entries_.begin(), entries_.end(), std::size_t(0),
        [](std::size_t sum, const Entry& entry) { return sum + entry.laplacian.memory(); });
}
