// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/fixed_lines.h"

namespace laplacian_lines {

void FixedLines::append(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                        LineSet& lines) {
    for (std::size_t i = 0; i < kFixedKindCount; ++i) {
        const LineKind kind = fixed_kinds()[i]->kind;
        if (style.shows[kind] && has_needs_of(kind, data))
            find(data, i).append(data, *this, eye, style, lines);
    }
}

std::shared_ptr<const LineSet> FixedLines::whole(const ExtractorData& data, LineKind kind,
                                                 const LineStyle& style) {
    for (std::size_t i = 0; i < kFixedKindCount; ++i)
        if (fixed_kinds()[i]->kind == kind && style.shows[kind])
            return find(data, i).whole(data, style);
    return nullptr;
}

const FixedKindLines& FixedLines::find(const ExtractorData& data, std::size_t number) {
    return *found_[number].get([&] { return fixed_kinds()[number]->find(data); });
}

}  // namespace laplacian_lines
