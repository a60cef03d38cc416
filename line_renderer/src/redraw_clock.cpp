// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/redraw_clock.h"

namespace line_renderer {

void RedrawClock::count(Part part) {
    const Clock::time_point now = Clock::now();
    spent_[part] += std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
}

double RedrawClock::ownMilliseconds() const {
    return spent_[Extraction] + spent_[Upload] + spent_[DrawCalls];
}

}  // namespace line_renderer
