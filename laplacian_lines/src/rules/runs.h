// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace laplacian_lines {

/// Calls use(begin, count) for the longest runs of places at which is_in(place), 0 <= place <
/// `places`, along a line. Of a closed one they may go on at its beginning, at i % places; all of
/// it is (0, places).
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
