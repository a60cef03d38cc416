// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

#include "clusters/extractor_data.h"
#include "clusters/local_eye.h"
#include "fixed/mesh_edges.h"
#include "fixed/ridges.h"
#include "laplacian_lines/line_set.h"
#include "laplacian_lines/line_style.h"

namespace laplacian_lines {

/// A value that is computed when it is first asked for. Thread-safe.
template <class Value>
class OnDemand {
public:
    template <class Compute>
    const Value& get(const Compute& compute) {
        std::call_once(once_, [&] { value_ = compute(); });
        return value_;
    }

private:
    std::once_flag once_;
    Value value_;
};

/// Lines that do not depend on the view, found when a style first shows them.
class FixedLines {
public:
    /// Appends what the style shows of ridges, borders and creases. The eye matters only
    /// for the nearness of contours, beside which ridges fade.
    void append(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                LineSet& lines);
    const MeshEdges& mesh_edges(const ExtractorData& data);

private:
    void append_ridges(const ExtractorData& data, const LocalEye& eye, const LineStyle& style,
                       float shortest, LineSet& lines);

    OnDemand<MeshEdges> mesh_edges_;
    OnDemand<Ridges> ridges_;
    OnDemand<LineSet> borders_, creases_;
};

}  // namespace laplacian_lines
