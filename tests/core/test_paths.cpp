// SPDX-License-Identifier: GPL-3.0-or-later
#include "test_paths.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

std::filesystem::path test_paths::repository() {
    return REPOSITORY;
}

std::string test_paths::content(const std::filesystem::path& file) {
    std::ifstream stream(repository() / file, std::ios::binary);
    if (!stream) throw std::runtime_error(file.string() + " cannot be read");
    return {std::istreambuf_iterator<char>(stream), {}};
}
