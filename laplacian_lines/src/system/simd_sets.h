// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Inner loops are compiled once for each instruction set, in a namespace SIMD_SET that is named
/// after it. All sets compute the same bits: the same operations in the same order, a·b + c is
/// never contracted, and no sum goes over lanes. CMakeLists.txt lists their files. Each has a table
/// of its functions, which others call by fastest<Table>().
///
/// They use functions of other headers only if these are static inline: of others, members among
/// them, the linker could keep the copy that was compiled for a better processor.
namespace laplacian_lines {

enum class InstructionSet { Baseline, Avx2, Avx512 };

/// The widest that the build and the processor have, with registers of at most
/// LAPLACIAN_LINES_VECTOR_BYTES of the environment (16, 32, 64), or what use_instruction_set()
/// asked for.
InstructionSet instruction_set();
/// For tests and benchmarks; false if the processor or the build does not have it. Not to be
/// called while anything is computed.
bool use_instruction_set(InstructionSet set);

/// Defined for each set, in the file of the functions.
template <class Table, InstructionSet set>
const Table& functions_of();

template <class Table>
const Table& fastest() {
#ifdef LAPLACIAN_LINES_X86_SETS
    if (instruction_set() == InstructionSet::Avx512)
        return functions_of<Table, InstructionSet::Avx512>();
    if (instruction_set() == InstructionSet::Avx2)
        return functions_of<Table, InstructionSet::Avx2>();
#endif
    return functions_of<Table, InstructionSet::Baseline>();
}

}  // namespace laplacian_lines
