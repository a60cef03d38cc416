// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace laplacian_lines {

// Chains of pieces joined at their ends. Ends 2p and 2p + 1 are the first and last of piece p.
// `link(end)` is the end that continues there, or kNoEnd.
constexpr std::uint32_t kNoEnd = 0xffffffffu;

/// Calls enter(end) for each piece, at the end where the chain enters it. Returns whether the chain
/// is closed.
template <class Link, class Enter>
bool follow_chain(std::uint32_t start, const Link& link, const Enter& enter) {
    std::uint32_t end = start;
    do {
        enter(end);
        end = link(end ^ 1);
    } while (end != kNoEnd && end != start);
    return end == start;
}

/// Calls trace(start) where chains begin; `trace` skips pieces that it has entered. First ends come
/// first, so that chains keep their pieces' direction; closed chains come last.
template <class Link, class Trace>
void for_each_chain(std::uint32_t pieces, const Link& link, const Trace& trace) {
    for (std::uint32_t side : {0u, 1u})
        for (std::uint32_t piece = 0; piece < pieces; ++piece)
            if (link(2 * piece + side) == kNoEnd) trace(2 * piece + side);
    for (std::uint32_t piece = 0; piece < pieces; ++piece)
        trace(2 * piece);
}

/// Calls use(begin, count) for the maximal runs of places at which is_in(place), 0 <= place <
/// `places`, along a line. Of a closed one they may go on or begin at its beginning, as i >= places
/// for place i % places; all of it is (0, places).
template <class IsIn, class Use>
void for_each_run(std::size_t places, bool is_closed, IsIn is_in, Use use) {
    std::size_t first = 0;  // a closed line is followed from where it is not in
    while (is_closed && first < places && is_in(first))
        ++first;
    if (first == places) first = 0;
    for (std::size_t begin = first, end; begin < first + places; begin = end + 1) {
        for (end = begin; end < first + places && is_in(end % places); ++end) {
        }
        if (end > begin) use(begin, end - begin);
    }
}

}  // namespace laplacian_lines
