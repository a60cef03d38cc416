// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <malloc.h>

#include <cstddef>
#include <fstream>
#include <string>

namespace benchmarks {

/// Memory that the process takes at most, beyond what it had when this was made. Linux only: the
/// kernel's mark of the largest resident size is set back, then read.
class PeakMemory {
public:
    PeakMemory() {
        malloc_trim(0);
        std::ofstream("/proc/self/clear_refs") << '5';
        before_ = resident("VmRSS:");
    }

    /// In bytes.
    double bytes() const { return resident("VmHWM:") - before_; }

private:
    static double resident(const std::string& name) {
        std::ifstream status("/proc/self/status");
        std::string word;
        while (status >> word)
            if (word == name) {
                double kilobytes = 0;
                status >> kilobytes;
                return 1024 * kilobytes;
            }
        return 0;
    }

    double before_ = 0;
};

}  // namespace benchmarks
