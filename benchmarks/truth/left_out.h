// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <set>
#include <string>
#include <utility>

namespace benchmarks {

/// Parts and directions of which the exact lines are wrong, from a file with lines of part,
/// direction and the reason, parted by tabulators; # begins a comment. A direction "*" is any.
class LeftOut {
public:
    LeftOut() = default;
    /// @throws std::runtime_error with the line that is not understood
    explicit LeftOut(const QString& file);

    bool has(const std::string& part, const std::string& view) const {
        return entries_.count({part, view}) || entries_.count({part, "*"});
    }

private:
    std::set<std::pair<std::string, std::string>> entries_;
};

}  // namespace benchmarks
