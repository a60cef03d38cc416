// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixed/fixed_lines.h"

namespace laplacian_lines {

void FixedLines::append(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                        LineSet& lines) {
    for (std::size_t i = 0; i < kFixedKindCount; ++i) {
        const FixedKind* const kind = fixed_kinds()[i];
        if (style.shows[kind->kind])
            found_[i].get([&] { return kind->find(data); })->append(data, eye, style, lines);
    }
}

}  // namespace laplacian_lines
