// SPDX-License-Identifier: GPL-3.0-or-later
// What mutants.py puts into sources calls. LAPLACIAN_LINES_MUTANT is the number of the active
// mutant; the file LAPLACIAN_LINES_MUTANTS_SEEN gets a 1 at the number of each place that ran and
// would have mattered.
#pragma once
#pragma GCC system_header
#pragma GCC diagnostic ignored "-Wuninitialized"  // in what is inlined into a changed function
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <type_traits>
#include <unistd.h>

namespace mutant {

constexpr int kMost = 1 << 16;

inline unsigned char* opened() {
    static unsigned char unread[kMost];
    const char* name = std::getenv("LAPLACIAN_LINES_MUTANTS_SEEN");
    const int file = name ? open(name, O_RDWR) : -1;
    if (file < 0) {
        return unread;
    }
    void* shared = mmap(nullptr, kMost, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    return shared == MAP_FAILED ? unread : static_cast<unsigned char*>(shared);
}

inline int number() {
    const char* text = std::getenv("LAPLACIAN_LINES_MUTANT");
    return text ? std::atoi(text) : -1;
}

inline unsigned char* const seen = opened();
inline const int active = number();

inline void see(int place) {
    if (!seen[place]) {
        seen[place] = 1; // by several threads at once: all write the same
    }
}

inline bool is_on(int place) {
    see(place);
    return place == active;
}

/// One of two comparisons: seen only if they differ.
template <typename Result>
Result either(int place, const Result& was, const Result& mutated) {
    if (std::memcmp(&was, &mutated, sizeof(Result)) != 0) {
        see(place);
    }
    return place == active ? mutated : was;
}
#define MUTANT_COMPARISON(name, before, after)                                                                         \
    template <typename A, typename B>                                                                                  \
    auto name(int place, const A& a, const B& b) {                                                                     \
        return either(place, a before b, a after b);                                                                   \
    }
MUTANT_COMPARISON(less_to_at_most, <, <=)
MUTANT_COMPARISON(more_to_at_least, >, >=)
MUTANT_COMPARISON(at_most_to_less, <=, <)
MUTANT_COMPARISON(at_least_to_more, >=, >)
MUTANT_COMPARISON(less_to_not, <, >=)
MUTANT_COMPARISON(more_to_not, >, <=)
MUTANT_COMPARISON(at_most_to_not, <=, >)
MUTANT_COMPARISON(at_least_to_not, >=, <)
MUTANT_COMPARISON(equal_to_not, ==, !=)
MUTANT_COMPARISON(not_to_equal, !=, ==)

/// The second operand of + or -, negated by the mutant.
template <typename T, typename = void>
struct Value {
    using type = T;
};
template <typename T>
struct Value<T, std::void_t<typename T::PlainObject>> { // a vector of Eigen
    using type = typename T::PlainObject;
};
template <typename T>
typename Value<T>::type sign(int place, const T& value) {
    if (is_on(place)) {
        return typename Value<T>::type(-value);
    }
    return value;
}

} // namespace mutant
