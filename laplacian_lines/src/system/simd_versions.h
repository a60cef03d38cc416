// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

// Versions of a function per instruction set level, each with vectors as wide as its registers: GCC
// sends wider ones through memory, up to ten times as slow, so cloning one loop will not do.
// Sanitizers get the baseline.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 && \
    !defined(LAPLACIAN_LINES_NO_VERSIONS)
#define LAPLACIAN_LINES_X86_VERSIONS
#endif

// What versions call has to be inlined to be compiled for their level.
#define LAPLACIAN_LINES_INLINE inline __attribute__((always_inline))

namespace laplacian_lines {

/// Specialized: GCC 12 loses the attribute on types that depend on a parameter.
template <class Number, std::size_t Bytes>
struct SimdVector;
#define LAPLACIAN_LINES_VECTOR(number, bytes)                               \
    template <>                                                             \
    struct SimdVector<number, bytes> {                                      \
        typedef number Type __attribute__((vector_size(bytes), may_alias)); \
    };
#define LAPLACIAN_LINES_VECTORS(bytes)    \
    LAPLACIAN_LINES_VECTOR(float, bytes)  \
    LAPLACIAN_LINES_VECTOR(double, bytes) \
    LAPLACIAN_LINES_VECTOR(std::int32_t, bytes)
LAPLACIAN_LINES_VECTORS(16)
LAPLACIAN_LINES_VECTORS(32)
LAPLACIAN_LINES_VECTORS(64)
#undef LAPLACIAN_LINES_VECTORS
#undef LAPLACIAN_LINES_VECTOR

/// Bytes of the widest registers that have versions and that the processor has, at most
/// LAPLACIAN_LINES_VECTOR_BYTES of the environment, for tests of the others.
std::size_t vector_bytes();

template <class Function>
Function* fastest_version(Function* baseline, Function* avx2, Function* avx512) {
    const std::size_t bytes = vector_bytes();
    return bytes >= 64 ? avx512 : bytes >= 32 ? avx2 : baseline;
}

}  // namespace laplacian_lines

#define LAPLACIAN_LINES_VERSION(name, target, bytes, parameters, ...) \
    target static auto name parameters {                              \
        [[maybe_unused]] constexpr std::size_t kBytes = bytes;        \
        return __VA_ARGS__;                                           \
    }

/// Defines the pointer fastest_`name` to a function with these parameters, in parentheses, that
/// returns the expression after them, in which kBytes is the size of the registers.
#ifdef LAPLACIAN_LINES_X86_VERSIONS
#define LAPLACIAN_LINES_VERSIONS(name, parameters, ...)                                   \
    LAPLACIAN_LINES_VERSION(baseline_##name, , 16, parameters, __VA_ARGS__)               \
    LAPLACIAN_LINES_VERSION(avx2_##name, __attribute__((target("arch=x86-64-v3"))), 32,   \
                            parameters, __VA_ARGS__)                                      \
    LAPLACIAN_LINES_VERSION(avx512_##name, __attribute__((target("arch=x86-64-v4"))), 64, \
                            parameters, __VA_ARGS__)                                      \
    static const auto fastest_##name =                                                    \
        fastest_version(&baseline_##name, &avx2_##name, &avx512_##name);
#else
#define LAPLACIAN_LINES_VERSIONS(name, parameters, ...)                     \
    LAPLACIAN_LINES_VERSION(baseline_##name, , 16, parameters, __VA_ARGS__) \
    static constexpr auto fastest_##name = &baseline_##name;
#endif
