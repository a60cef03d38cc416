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
    end_turn_soon();
}

bool LineCache::is_check_due(View view, int mesh, const Eigen::Matrix4d& modelview,
                             QWidget* widget) {
    const auto found = uses_.find({view, mesh});
    return found == uses_.end() || found->second.check.is_due(modelview, presses_.value(), widget);
}

void LineCache::release(View view, int mesh) {
    const auto found = uses_.find({view, mesh});
    if (found != uses_.end()) retire(found);
}

void LineCache::release_view(View view) {
    retire_if(view, [](const Uses::value_type&) { return true; });
}

void LineCache::release_all_but(View view, const std::vector<int>& alive) {
    retire_if(view, [&](const Uses::value_type& use) {
        return !std::binary_search(alive.begin(), alive.end(), use.first.second);
    });
}

void LineCache::release_unless_assigned(View view) {
    unsure_views_.insert(view);
    end_turn_soon();
}

LineCache::Uses::iterator LineCache::retire(Uses::iterator use) {
    retired_.push_back(std::move(use->second.lines));
    end_turn_soon();
    return uses_.erase(use);
}

template <class Condition>
void LineCache::retire_if(View view, Condition condition) {
    auto use = uses_.lower_bound({view, std::numeric_limits<int>::min()});
    while (use != uses_.end() && use->first.first == view)
        use = condition(*use) ? retire(use) : std::next(use);
}

void LineCache::end_turn_soon() {
    if (turn_end_is_due_) return;
    turn_end_is_due_ = true;
    QTimer::singleShot(0, &receiver_, [this] { end_turn(); });
}

void LineCache::end_turn() {
    for (View view : unsure_views_)
        retire_if(view, [this](const Uses::value_type& use) { return use.second.turn != turn_; });
    unsure_views_.clear();
    retired_.clear();
    for (auto known = known_.begin(); known != known_.end();)
        known = known->second.expired() ? known_.erase(known) : std::next(known);
    ++turn_;
    turn_end_is_due_ = false;
}

std::size_t KeptLines::usual_bytes() {
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
    return pages > 0 && page > 0 ? std::size_t(pages) / 4 * std::size_t(page) : 0;
}

void KeptLines::keep(Document document, int mesh, PreparedLinesPointer lines) {
    entries_.remove_if(
        [=](const Entry& entry) { return entry.document == document && entry.mesh == mesh; });
    if (lines->is_out_of_memory) return;
    entries_.push_front({document, mesh, std::move(lines)});
    while (bytes() > most_bytes_)
        entries_.pop_back();
}

void KeptLines::forget_all_but(Document document, const std::vector<int>& alive) {
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
