// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_header.h"

#include <array>

namespace mesh_files {
namespace {

struct TypeNames {
    const char *old_name, *name;
    std::size_t size;
};
/// By PlyType.
constexpr std::array<TypeNames, 8> kTypes = {{{"char", "int8", 1},
                                              {"uchar", "uint8", 1},
                                              {"short", "int16", 2},
                                              {"ushort", "uint16", 2},
                                              {"int", "int32", 4},
                                              {"uint", "uint32", 4},
                                              {"float", "float32", 4},
                                              {"double", "float64", 8}}};

PlyType type_in(std::string_view word) {
    for (std::size_t i = 0; i < kTypes.size(); ++i)
        if (word == kTypes[i].old_name || word == kTypes[i].name) return PlyType(i);
    throw Defect{quoted(word) + " is not a type of PLY files"};
}

PlyHeader::Encoding encoding_in(std::string_view rest) {
    const std::string_view word = take_word(rest), version = take_word(rest);
    if (version != "1.0") throw Defect{"version " + quoted(version) + " is not known"};
    if (word == "ascii") return PlyHeader::Encoding::Text;
    if (word == "binary_little_endian") return PlyHeader::Encoding::LittleEndian;
    if (word == "binary_big_endian") return PlyHeader::Encoding::BigEndian;
    throw Defect{quoted(word) + " is not a format of PLY files"};
}

PlyElement element_in(std::string_view rest) {
    PlyElement element;
    element.name = take_word(rest);
    const std::string_view word = take_word(rest);
    const std::int64_t count = integer_in(word);
    if (count < 0) throw Defect{quoted(word) + " is not a number of elements"};
    element.count = std::uint64_t(count);
    return element;
}

PlyProperty property_in(std::string_view rest) {
    PlyProperty property{};
    std::string_view word = take_word(rest);
    if (word == "list") {
        property.count_type = type_in(take_word(rest));
        if (*property.count_type >= PlyType::Float32)
            throw Defect{"the number of entries of a list is not a whole number"};
        word = take_word(rest);
    }
    property.type = type_in(word);
    property.name = take_word(rest);
    if (property.name.empty()) throw Defect{"a property has no name"};
    return property;
}

}  // namespace

std::size_t size_of(PlyType type) {
    return kTypes[std::size_t(type)].size;
}

std::size_t PlyElement::least_size(bool is_text) const {
    std::size_t sum = 0;
    for (const PlyProperty& property : properties)
        sum += is_text ? 1 : size_of(property.count_type.value_or(property.type));
    return sum;
}

PlyHeader read_ply_header(Text& text) {
    std::string_view line;
    if (!text.next_line(line) || take_word(line) != "ply")
        throw Defect{"it does not begin with \"ply\""};
    PlyHeader header;
    bool has_format = false;
    while (text.next_line(line)) {
        const std::string_view key = take_word(line);
        if (key == "format") {
            header.encoding = encoding_in(line);
            has_format = true;
        } else if (key == "element") {
            header.elements.push_back(element_in(line));
        } else if (key == "property") {
            if (header.elements.empty()) throw Defect{"a property belongs to no element"};
            header.elements.back().properties.push_back(property_in(line));
        } else if (key == "end_header") {
            if (!has_format) throw Defect{"its header does not name the format"};
            return header;
        } else if (!key.empty() && key != "comment" && key != "obj_info") {
            throw Defect{quoted(key) + " is not known in headers of PLY files"};
        }
    }
    throw Defect{"it ends within its header"};
}

}  // namespace mesh_files
