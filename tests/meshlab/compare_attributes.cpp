// SPDX-License-Identifier: GPL-3.0-or-later
// compare_attributes MESH.ply REFERENCE.txt TOLERANCE: whether the attributes in a file that
// MeshLab has saved (binary, little-endian) are those that write_reference computed. Differences
// count in parts of the largest value of an attribute. Exit codes: 0 yes, 1 no, 2 unusable files.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Attributes =
    std::map<std::string, std::vector<double>>;  ///< values by vertex, then component

struct Property {
    std::string name, type;
    bool is_list = false;  ///< of up to 255 items
};

struct Header {
    std::size_t vertices = 0;
    std::vector<Property> properties;  ///< of the vertices
};

Header read_header(std::istream& file) {
    Header header;
    std::string line, element;
    while (std::getline(file, line) && line != "end_header") {
        std::istringstream words(line);
        std::string word, count_type;
        words >> word;
        if (word == "format" && line.find("binary_little_endian") == std::string::npos)
            throw std::runtime_error("the mesh is not binary");
        if (word == "element") {
            std::size_t count = 0;
            words >> element >> count;
            if (element == "vertex") header.vertices = count;
        } else if (word == "property" && element == "vertex") {
            Property property;
            words >> property.type;
            property.is_list = property.type == "list";
            if (property.is_list) words >> count_type >> property.type;
            words >> property.name;
            header.properties.push_back(property);
        }
    }
    if (!file || header.vertices == 0) throw std::runtime_error("the mesh has no header");
    return header;
}

template <class T>
double read_as(std::istream& file) {
    T value;
    if (!file.read(reinterpret_cast<char*>(&value), sizeof value))
        throw std::runtime_error("the mesh ends early");
    return double(value);
}

double read_number(std::istream& file, const std::string& type) {
    if (type == "float") return read_as<float>(file);
    if (type == "double") return read_as<double>(file);
    if (type == "int" || type == "uint") return read_as<std::int32_t>(file);
    if (type == "uchar" || type == "char") return read_as<std::uint8_t>(file);
    throw std::runtime_error("the mesh has a property of the type " + type);
}

/// MeshLab 2020.09 writes a vector as three properties, later ones as one list.
std::string attribute_of(const std::string& property) {
    const std::string end = property.size() > 2 ? property.substr(property.size() - 2) : "";
    return end == "_x" || end == "_y" || end == "_z" ? property.substr(0, property.size() - 2)
                                                     : property;
}

Attributes read_mesh(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path);
    const Header header = read_header(file);
    Attributes attributes;
    for (std::size_t v = 0; v < header.vertices; ++v)
        for (const Property& property : header.properties) {
            const int items = property.is_list ? int(read_number(file, "uchar")) : 1;
            for (int i = 0; i < items; ++i)
                attributes[attribute_of(property.name)].push_back(read_number(file, property.type));
        }
    return attributes;
}

using Layout = std::vector<std::pair<std::string, int>>;  ///< names and numbers of items

/// Of "# NAME:NUMBER...", as write_reference writes it, without the truth that comes last.
Layout read_layout(std::istream& file) {
    std::string line, word;
    std::getline(file, line);
    std::istringstream words(line);
    Layout layout;
    if (words >> word && word == "#")
        while (words >> word && word.rfind("true_", 0) != 0) {
            const std::size_t colon = word.find(':');
            if (colon == std::string::npos) throw std::runtime_error("an attribute has no length");
            layout.emplace_back(word.substr(0, colon), std::atoi(word.c_str() + colon + 1));
        }
    if (layout.empty()) throw std::runtime_error("the reference does not tell its layout");
    return layout;
}

Attributes read_reference(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    const Layout layout = read_layout(file);
    Attributes attributes;
    for (std::string line; std::getline(file, line);) {
        std::istringstream numbers(line);
        for (const auto& [name, items] : layout)
            for (int i = 0; i < items; ++i) {
                float value = 0;
                if (!(numbers >> value)) throw std::runtime_error("the reference ends early");
                attributes[name].push_back(value);
            }
    }
    return attributes;
}

/// Infinite where one is not finite or values are missing.
double difference(const std::vector<double>& found, const std::vector<double>& expected) {
    if (found.size() != expected.size()) return INFINITY;
    double largest = 0, worst = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        largest = std::max(largest, std::abs(expected[i]));
        const double error = std::abs(found[i] - expected[i]);
        worst = std::isfinite(error) ? std::max(worst, error) : INFINITY;
    }
    return worst / largest;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "compare_attributes MESH.ply REFERENCE.txt TOLERANCE\n");
        return 2;
    }
    try {
        Attributes mesh = read_mesh(argv[1]);
        bool same = true;
        for (const auto& [name, expected] : read_reference(argv[2])) {
            const double found = difference(mesh[name], expected);
            std::printf("%s: %zu numbers, difference %.3g\n", name.c_str(), expected.size(), found);
            same = same && found <= std::atof(argv[3]);
        }
        return same ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "compare_attributes: %s\n", error.what());
        return 2;
    }
}
