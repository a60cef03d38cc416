// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>

namespace line_renderer {

/// Where the time of a redraw goes.
class RedrawClock {
public:
    enum Part {
        Extraction,
        Upload,
        DrawCalls,  ///< telling OpenGL what to draw, and all that is not one of the others
        /// By OpenGL: the call that begins it, in which a software renderer does half of it, and
        /// waiting for its end.
        Drawing,
        part_count
    };

    /// The time since the last call, at first since construction, counts for this part.
    void count(Part part) {
        const Clock::time_point now = Clock::now();
        spent_[part] += std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
    }

    double milliseconds(Part part) const { return spent_[part]; }
    /// What the plugin itself takes of a redraw: all but waiting for OpenGL.
    double ownMilliseconds() const {
        return spent_[Extraction] + spent_[Upload] + spent_[DrawCalls];
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
    std::array<double, part_count> spent_{};  // milliseconds
};

}  // namespace line_renderer
