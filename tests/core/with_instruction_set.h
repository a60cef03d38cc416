// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "system/simd_sets.h"

/// Restores the set of before.
class WithInstructionSet {
public:
    explicit WithInstructionSet(laplacian_lines::InstructionSet set) {
        laplacian_lines::use_instruction_set(set);
    }
    ~WithInstructionSet() { laplacian_lines::use_instruction_set(before_); }
    WithInstructionSet(const WithInstructionSet&) = delete;
    WithInstructionSet& operator=(const WithInstructionSet&) = delete;

private:
    const laplacian_lines::InstructionSet before_ = laplacian_lines::instruction_set();
};

/// What the processor and the build have but for the widest, which is in use.
inline std::vector<laplacian_lines::InstructionSet> narrower_sets() {
    std::vector<laplacian_lines::InstructionSet> sets;
    for (int set = 0; set < int(laplacian_lines::instruction_set()); ++set)
        sets.push_back(laplacian_lines::InstructionSet(set));
    return sets;
}
