// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/fixed_kinds.h"
#include "system/on_demand.h"

namespace laplacian_lines {

/// Found when a style first shows them. Thread-safe.
class FixedLines {
public:
    /// Appends what the style shows, kind after kind.
    void append(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                LineSet& lines);

    /// FixedKindLines::whole(); null unless the style shows the kind.
    std::shared_ptr<const LineSet> whole(const ExtractorData& data, LineKind kind,
                                         const LineStyle& style);

private:
    const FixedKindLines& find(const ExtractorData& data, std::size_t number);

    std::array<OnDemand<std::unique_ptr<const FixedKindLines>>, kFixedKindCount> found_;
};

}  // namespace laplacian_lines
