// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>

namespace line_renderer {

/// Times the parts of a redraw.
class RedrawClock {
public:
    enum Part {
        Extraction,
        Upload,
        DrawCalls,  ///< preparing them, and all that is not one of the others
        /// By OpenGL: the calls, in which a software renderer does half the work, and glFinish().
        Drawing,
        kPartCount
    };

    /// Adds the time since the last call, or since construction, to a part.
    void count(Part part) {
        const Clock::time_point now = Clock::now();
        spent_[part] += std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
    }

    double milliseconds(Part part) const { return spent_[part]; }
    /// The plugin's own share: all but waiting for OpenGL.
    double own_milliseconds() const {
        return spent_[Extraction] + spent_[Upload] + spent_[DrawCalls];
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
    std::array<double, kPartCount> spent_{};  // milliseconds
};

}  // namespace line_renderer
