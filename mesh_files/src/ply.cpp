// SPDX-License-Identifier: GPL-3.0-or-later
// Stanford's PLY (Turk 1994): vertices with faces or triangle strips.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "mesh_builder.h"
#include "text.h"

namespace mesh_files {
namespace {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

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

std::size_t size_of(PlyType type) {
    return kTypes[std::size_t(type)].size;
}

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> count_type;  ///< of lists
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// The least bytes of an item, whose lists may be empty.
    std::size_t least_size(bool is_text) const {
        std::size_t sum = 0;
        for (const PlyProperty& property : properties)
            sum += is_text ? 1 : size_of(property.count_type.value_or(property.type));
        return sum;
    }
};

struct PlyHeader {
    enum class Encoding { Text, LittleEndian, BigEndian };
    Encoding encoding = Encoding::Text;
    std::vector<PlyElement> elements;
};

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

/// Through the line end_header. @throws Defect
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

class TextValues {
public:
    explicit TextValues(Text& text) : text_(text) {}

    double next(PlyType type) {
        const std::string_view word = text_.next_word();
        if (word.empty()) throw Defect{"it ends"};
        if (type < PlyType::Float32) return double(integer_in(word));
        const double number = number_in(word);
        return type == PlyType::Float32 ? double(float(number)) : number;  // as binary files do
    }
    std::string_view rest() const { return text_.rest(); }

private:
    Text& text_;
};

template <class Number>
Number big_endian(const char* bytes) {
    char turned[sizeof(Number)];
    std::reverse_copy(bytes, bytes + sizeof(Number), turned);
    return little_endian<Number>(turned);
}

template <bool big>
class BinaryValues {
public:
    explicit BinaryValues(std::string_view bytes) : bytes_(bytes) {}

    double next(PlyType type) {
        if (bytes_.size() < size_of(type)) throw Defect{"it ends"};
        const char* at = bytes_.data();
        bytes_.remove_prefix(size_of(type));
        constexpr double (*numbers[])(const char*) = {number<std::int8_t>,  number<std::uint8_t>,
                                                      number<std::int16_t>, number<std::uint16_t>,
                                                      number<std::int32_t>, number<std::uint32_t>,
                                                      number<float>,        number<double>};
        return numbers[std::size_t(type)](at);
    }
    std::string_view rest() const { return bytes_; }

private:
    template <class Number>
    static double number(const char* at) {
        return double(big ? big_endian<Number>(at) : little_endian<Number>(at));
    }

    std::string_view bytes_;
};

/// Of a property; X to Z, of coordinates, are numbers of axes and come first.
enum class Role { X, Y, Z, Corners, Strips, Nothing };

Role role_of(const PlyElement& element, const PlyProperty& property) {
    const std::string& name = property.name;
    if (property.count_type) {
        if (name != "vertex_indices" && name != "vertex_index") return Role::Nothing;
        return element.name == "face"        ? Role::Corners
               : element.name == "tristrips" ? Role::Strips
                                             : Role::Nothing;
    }
    if (element.name != "vertex" || name.size() != 1 || name[0] < 'x' || name[0] > 'z')
        return Role::Nothing;
    return Role(name[0] - 'x');
}

template <class Values>
class PlyReader {
public:
    PlyReader(Values values, MeshBuilder& mesh) : values_(std::move(values)), mesh_(mesh) {}

    void read(const PlyElement& element) {
        roles_.clear();
        for (const PlyProperty& property : element.properties)
            roles_.push_back(role_of(element, property));
        const bool is_vertex = element.name == "vertex";
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            try {
                read_item(element, is_vertex);
            } catch (const Defect& defect) {
                throw Defect{defect.what + ", in " + element.name + ' ' + std::to_string(i + 1) +
                             " of " + std::to_string(element.count)};
            }
        }
    }

    std::string_view rest() const { return values_.rest(); }

private:
    void read_item(const PlyElement& element, bool is_vertex) {
        Eigen::Vector3d position(NAN, NAN, NAN);
        for (std::size_t k = 0; k < roles_.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (property.count_type) {
                read_list(property);
                if (roles_[k] == Role::Corners) mesh_.add(list_);
                if (roles_[k] == Role::Strips) add_strips();
                continue;
            }
            const double value = values_.next(property.type);
            if (roles_[k] <= Role::Z) position[int(roles_[k])] = value;
        }
        if (is_vertex) mesh_.add(position);
    }

    void read_list(const PlyProperty& property) {
        const double count = values_.next(*property.count_type);
        if (count < 0) throw Defect{"a list has a negative number of entries"};
        list_.clear();
        for (double k = 0; k < count; ++k) {
            const double value = values_.next(property.type);
            const bool is_index = std::abs(value) < 1e18 && value == std::floor(value);
            list_.push_back(is_index ? std::int64_t(value) : kNoIndex);
        }
    }

    // refused as others out of range are; not −1, which ends strips
    static constexpr std::int64_t kNoIndex = -2;

    /// -1 ends a strip; every second triangle is reversed.
    void add_strips() {
        std::size_t first = 0;
        for (std::size_t k = 0; k < list_.size(); ++k) {
            if (list_[k] == -1) first = k + 1;
            if (k < first + 2) continue;
            const bool odd = (k - first) % 2 == 1;
            mesh_.add_triangle(list_[k - 2 + odd], list_[k - 1 - odd], list_[k]);
        }
    }

    Values values_;
    MeshBuilder& mesh_;
    std::vector<Role> roles_;  // by property
    std::vector<std::int64_t> list_;
};

void expect_coordinates(const PlyElement& vertices) {
    for (const char* name : {"x", "y", "z"})
        if (std::none_of(vertices.properties.begin(), vertices.properties.end(),
                         [&](const PlyProperty& p) { return p.name == name && !p.count_type; }))
            throw Defect{std::string("its vertices have no ") + name};
}

/// Reserves room for what the header promises, at most for what the bytes can hold: a triangle
/// takes three bytes at least.
void reserve(const PlyHeader& header, std::size_t bytes, MeshBuilder& mesh) {
    const bool is_text = header.encoding == PlyHeader::Encoding::Text;
    for (const PlyElement& element : header.elements) {
        if (element.properties.empty()) continue;
        const auto most = std::size_t(
            std::min<std::uint64_t>(element.count, bytes / element.least_size(is_text)));
        if (element.name == "vertex") {
            mesh.reserve_vertices(most);
            mesh.expect_vertices(element.count);
        }
        if (element.name == "face") mesh.reserve_triangles(std::min(most, bytes / 3));
    }
}

template <class Values>
std::string read_elements(const PlyHeader& header, Values values, MeshBuilder& mesh) {
    PlyReader<Values> reader(std::move(values), mesh);
    for (const PlyElement& element : header.elements)
        reader.read(element);
    return unread(reader.rest());
}

}  // namespace

std::string read_ply(std::string_view bytes, MeshBuilder& mesh) {
    Text text(bytes);
    PlyHeader header;
    read_lines(text, [&] {
        header = read_ply_header(text);
        for (const PlyElement& element : header.elements)
            if (element.name == "vertex") expect_coordinates(element);
    });
    reserve(header, text.rest().size(), mesh);
    if (header.encoding == PlyHeader::Encoding::Text)
        return read_lines(text, [&] { return read_elements(header, TextValues(text), mesh); });
    if (header.encoding == PlyHeader::Encoding::LittleEndian)
        return read_elements(header, BinaryValues<false>(text.rest()), mesh);
    return read_elements(header, BinaryValues<true>(text.rest()), mesh);
}

}  // namespace mesh_files
