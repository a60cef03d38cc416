// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <vector>

namespace benchmarks {

/// What else runs on the machine.
enum class Load {
    Quiet,     ///< nothing of ours
    Stream,    ///< a process that copies memory, more than caches hold
    Cores,     ///< on all processors but one, a process that only computes
    AllCores,  ///< on all processors
};

/// Processes that make these loads; all are stopped at first, and gone with this object or with the
/// process that has made it. To be made before threads are. @throws std::runtime_error
class Neighbours {
public:
    Neighbours();
    ~Neighbours();
    Neighbours(const Neighbours&) = delete;
    Neighbours& operator=(const Neighbours&) = delete;

    /// Returns when the processes of this load run, and no others of ours.
    void set(Load load) const;

private:
    void start(std::vector<pid_t>& group, void (*work)());
    void end() const;

    std::vector<pid_t> stream_, cores_;
};

}  // namespace benchmarks
