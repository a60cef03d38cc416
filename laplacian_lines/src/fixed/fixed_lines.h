// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fixed/fixed_kinds.h"
#include "system/on_demand.h"

namespace laplacian_lines {

/// Lines that do not depend on the view, found when a style first shows them. Thread-safe.
class FixedLines {
public:
    /// Appends what the style shows of them, kind after kind.
    void append(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                LineSet& lines);

private:
    std::array<OnDemand<std::unique_ptr<const FixedKindLines>>, kFixedKindCount> found_;
};

}  // namespace laplacian_lines
