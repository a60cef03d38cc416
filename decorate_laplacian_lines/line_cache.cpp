// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_cache.h"

#include <unistd.h>

#include <QTimer>
#include <algorithm>
#include <limits>

PreparedLinesPointer LineCache::find(const meshlab_host::FieldKey& key) const {
    const auto found = known_.find(key);
    return found == known_.end() ? nullptr : found->second.lock();
}

PreparedLinesPointer LineCache::at(View view, int mesh) const {
    const auto found = uses_.find({view, mesh});
    return found == uses_.end() ? nullptr : found->second.lines;
}

void LineCache::assign(View view, int mesh, PreparedLinesPointer lines) {
    release(view, mesh);
    known_[lines->key] = lines;
    Use& use = uses_[{view, mesh}];
    use.lines = std::move(lines);
    use.turn = turn_;
    endTurnSoon();
}

bool LineCache::isCheckDue(View view, int mesh, const Eigen::Matrix4d& modelview, QWidget* widget) {
    const auto found = uses_.find({view, mesh});
    return found == uses_.end() || found->second.check.isDue(modelview, presses_.value(), widget);
}

void LineCache::release(View view, int mesh) {
    const auto found = uses_.find({view, mesh});
    if (found != uses_.end()) retire(found);
}

void LineCache::releaseView(View view) {
    retireIf(view, [](const Uses::value_type&) { return true; });
}

void LineCache::releaseAllBut(View view, const std::vector<int>& alive) {
    retireIf(view, [&](const Uses::value_type& use) {
        return !std::binary_search(alive.begin(), alive.end(), use.first.second);
    });
}

void LineCache::releaseUnlessAssigned(View view) {
    unsure_views_.insert(view);
    endTurnSoon();
}

LineCache::Uses::iterator LineCache::retire(Uses::iterator use) {
    retired_.push_back(std::move(use->second.lines));
    endTurnSoon();
    return uses_.erase(use);
}

template <class Condition>
void LineCache::retireIf(View view, Condition condition) {
    auto use = uses_.lower_bound({view, std::numeric_limits<int>::min()});
    while (use != uses_.end() && use->first.first == view)
        use = condition(*use) ? retire(use) : std::next(use);
}

void LineCache::endTurnSoon() {
    if (turn_end_is_due_) return;
    turn_end_is_due_ = true;
    QTimer::singleShot(0, &receiver_, [this] { endTurn(); });
}

void LineCache::endTurn() {
    for (View view : unsure_views_)
        retireIf(view, [this](const Uses::value_type& use) { return use.second.turn != turn_; });
    unsure_views_.clear();
    retired_.clear();
    for (auto known = known_.begin(); known != known_.end();)
        known = known->second.expired() ? known_.erase(known) : std::next(known);
    ++turn_;
    turn_end_is_due_ = false;
}

std::size_t KeptLines::usualBytes() {
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
    return pages > 0 && page > 0 ? std::size_t(pages) / 4 * std::size_t(page) : 0;
}

void KeptLines::keep(Document document, int mesh, PreparedLinesPointer lines) {
    entries_.remove_if(
        [=](const Entry& entry) { return entry.document == document && entry.mesh == mesh; });
    if (lines->lacked_memory) return;
    entries_.push_front({document, mesh, std::move(lines)});
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
