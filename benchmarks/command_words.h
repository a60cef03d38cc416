// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace benchmarks {

/// The files among a program's words. Words that begin with - are options and have a value; each is
/// handed to set(option, value), which returns whether it knows the option.
/// @throws std::invalid_argument for an unknown option and for one without a value.
template <class Set>
std::vector<std::string> files_among(int argc, char** argv, Set set) {
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word[0] != '-') {
            files.push_back(word);
            continue;
        }
        if (++i == argc) throw std::invalid_argument(word + " needs a value");
        if (!set(word, std::string(argv[i]))) throw std::invalid_argument("unknown option " + word);
    }
    return files;
}

}  // namespace benchmarks
