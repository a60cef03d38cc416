// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

namespace driver {

/// Random choices that are the same for a seed with every compiler and library.
class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}

    int below(int end) { return int(engine_() % unsigned(end)); }
    bool oneIn(int n) { return below(n) == 0; }
    /// With three digits behind the point.
    double between(double from, double to) { return from + (to - from) * below(1001) / 1000; }
    template <class List>
    const typename List::value_type& from(const List& list) {
        return *(list.begin() + below(int(list.size())));
    }

private:
    std::mt19937 engine_;
};

}  // namespace driver
