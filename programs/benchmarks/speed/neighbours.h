// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <vector>

namespace benchmarks {

enum class Load {
    Quiet,     ///< nothing of ours
    Stream,    ///< a process that copies memory, more than caches hold
    Cores,     ///< on all processors but one, a process that only computes
    AllCores,  ///< on all processors
};

/// Processes that make these loads, first stopped, gone with this object or its process. Make it
/// before threads. @throws std::runtime_error
class Neighbours {
public:
    Neighbours();
    ~Neighbours();
    Neighbours(const Neighbours&) = delete;
    Neighbours& operator=(const Neighbours&) = delete;

    /// Returns when only the processes of this load run.
    void set(Load load) const;

private:
    void start(std::vector<pid_t>& group, void (*work)());
    void end() const;

    std::vector<pid_t> stream_, cores_;
};

}  // namespace benchmarks
