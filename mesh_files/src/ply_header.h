// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "text.h"

namespace mesh_files {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> count_type;  ///< of lists
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// The least bytes of an item.
    std::size_t least_size(bool is_text) const;
};

struct PlyHeader {
    enum class Encoding { Text, LittleEndian, BigEndian };
    Encoding encoding = Encoding::Text;
    std::vector<PlyElement> elements;
};

/// Through the line end_header. @throws Defect
PlyHeader read_ply_header(Text& text);

}  // namespace mesh_files
