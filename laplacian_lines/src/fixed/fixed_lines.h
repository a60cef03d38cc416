// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <mutex>

#include "clusters/extractor_data.h"
#include "fixed/surface.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/line_style.h"
#include "system/on_demand.h"

namespace laplacian_lines {

class FixedLines;

/// The lines of one kind on a mesh, found once. Thread-safe.
class FixedKindLines {
public:
    virtual ~FixedKindLines() = default;
    /// Appends what the style shows. The eye only matters if that includes contours; `all` has the
    /// other kinds, whose lines are not doubled.
    virtual void append(const ExtractorData& data, FixedLines& all, const LocalEye& eye,
                        const LineStyle& style, LineSet& lines) const = 0;
    /// What the style can show from any eye, the same object while that stays the same; null for
    /// kinds that no other kind needs.
    virtual std::shared_ptr<const LineSet> whole(const ExtractorData&, FixedLines&,
                                                 const LineStyle&) const {
        return nullptr;
    }
};

struct FixedKind {
    LineKind kind;
    std::unique_ptr<const FixedKindLines> (*find)(const ExtractorData& data, FixedLines& all);
};

/// `Lines` is constructed from the data and what the kinds share.
template <class Lines>
constexpr FixedKind fixed_kind(LineKind kind) {
    return {
        kind,
        [](const ExtractorData& data, FixedLines& all) -> std::unique_ptr<const FixedKindLines> {
            return std::make_unique<const Lines>(data, all);
        }};
}

extern const FixedKind kRidges;             ///< ridges.cpp
extern const FixedKind kBorders;            ///< borders.cpp
extern const FixedKind kCreases;            ///< creases.cpp
extern const FixedKind kValleys;            ///< ridges.cpp
extern const FixedKind kDemarcatingCurves;  ///< demarcating_curves.cpp

inline constexpr std::array kFixedKinds = {&kRidges, &kBorders, &kCreases, &kValleys,
                                           &kDemarcatingCurves};

/// Found when a style first shows them. Thread-safe.
class FixedLines {
public:
    /// Appends what the style shows, kind after kind.
    void append(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                LineSet& lines);

    /// FixedKindLines::whole(); null unless the style shows the kind.
    std::shared_ptr<const LineSet> whole(const ExtractorData& data, LineKind kind,
                                         const LineStyle& style);

    /// Kept until lines have been appended; not longer, for it is large.
    std::shared_ptr<const Surface> surface(const ExtractorData& data);

private:
    const FixedKindLines& find(const ExtractorData& data, std::size_t number);

    std::array<OnDemand<std::unique_ptr<const FixedKindLines>>, kFixedKinds.size()> found_;
    std::mutex mutex_;
    std::shared_ptr<const Surface> surface_;
};

}  // namespace laplacian_lines
