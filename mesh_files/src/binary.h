// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>

namespace mesh_files {

/// A number at any address. MeshLab's machines all are little-endian.
template <class Number>
Number little_endian(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

template <class Number>
Number big_endian(const char* bytes) {
    char turned[sizeof(Number)];
    std::reverse_copy(bytes, bytes + sizeof(Number), turned);
    return little_endian<Number>(turned);
}

}  // namespace mesh_files
