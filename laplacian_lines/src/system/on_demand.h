// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

namespace laplacian_lines {

/// A value computed when it is first asked for. Thread-safe; if that throws, the next caller tries
/// again.
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

}  // namespace laplacian_lines
