// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One version for each level of the instruction set, chosen when the program starts. Named levels
// (GCC 12) look at what the processor can do; "arch=" with a processor's name would look for that
// very model. Sanitizers cannot resolve clones.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 && \
    !defined(LAPLACIAN_LINES_NO_CLONES)
#define LAPLACIAN_LINES_CLONES \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
// Whether functions can be compiled for a level by __attribute__((target("arch=x86-64-v4"))), for
// loops that are written differently for each.
#define LAPLACIAN_LINES_LEVELS
#else
#define LAPLACIAN_LINES_CLONES
#endif

// Code of clones that sits in functions of its own has to be inlined to be cloned with them.
#define LAPLACIAN_LINES_INLINE inline __attribute__((always_inline))
