// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/fixed_lines.h"

namespace laplacian_lines {

void FixedLines::append(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                        LineSet& lines) {
    for (std::size_t i = 0; i < kFixedKinds.size(); ++i) {
        const LineKind kind = kFixedKinds[i]->kind;
        if (style.shows[kind] && can_extract(kind, data))
            find(data, i).append(data, *this, eye, style, lines);
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    surface_.reset();
}

std::shared_ptr<const LineSet> FixedLines::whole(const ExtractorData& data, LineKind kind,
                                                 const LineStyle& style) {
    for (std::size_t i = 0; i < kFixedKinds.size(); ++i)
        if (kFixedKinds[i]->kind == kind && style.shows[kind])
            return find(data, i).whole(data, *this, style);
    return nullptr;
}

std::shared_ptr<const Surface> FixedLines::surface(const ExtractorData& data) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!surface_) surface_ = std::make_shared<const Surface>(data);
    return surface_;
}

const FixedKindLines& FixedLines::find(const ExtractorData& data, std::size_t number) {
    return *found_[number].get([&] { return kFixedKinds[number]->find(data, *this); });
}

}  // namespace laplacian_lines
