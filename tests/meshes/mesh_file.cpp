// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_file.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace test_meshes {
namespace {

using laplacian_lines::TriangleMesh;

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && !text.compare(text.size() - end.size(), end.size(), end);
}

std::string unpacked(const std::string& path) {
    if (path.find('\'') != std::string::npos) throw std::runtime_error("quote in " + path);
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(
        popen(("gzip -dc '" + path + "'").c_str(), "r"), pclose);
    if (!pipe) throw std::runtime_error("cannot run gzip");
    std::string content;
    char buffer[1 << 16];
    for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe.get())) > 0;)
        content.append(buffer, n);
    return content;
}

std::string file_content(const std::string& path) {
    if (ends_with(path, ".gz")) return unpacked(path);
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
}

void add_fan(TriangleMesh& mesh, const std::vector<long>& corners) {
    for (std::size_t k = 2; k < corners.size(); ++k)
        mesh.triangles.push_back(
            {std::uint32_t(corners[0]), std::uint32_t(corners[k - 1]), std::uint32_t(corners[k])});
}

/// −1 ends a strip; every second triangle of a strip is turned round.
void add_strips(TriangleMesh& mesh, const std::vector<long>& corners) {
    std::size_t first = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (corners[k] < 0) first = k + 1;
        if (k < first + 2) continue;
        const bool odd = (k - first) % 2 == 1;
        mesh.triangles.push_back({std::uint32_t(corners[k - 2 + odd]),
                                  std::uint32_t(corners[k - 1 - odd]), std::uint32_t(corners[k])});
    }
}

TriangleMesh read_obj(std::istream& file) {
    TriangleMesh mesh;
    for (std::string text; std::getline(file, text);) {
        std::istringstream line(text);
        std::string key, corner;
        line >> key;
        if (key == "v") {
            Eigen::Vector3d p;
            line >> p.x() >> p.y() >> p.z();
            mesh.positions.push_back(p);
        } else if (key == "f") {
            std::vector<long> corners;
            while (line >> corner) {
                const long index = std::stol(corner);  // stops at the first slash
                corners.push_back(index > 0 ? index - 1 : long(mesh.positions.size()) + index);
            }
            add_fan(mesh, corners);
        }
    }
    return mesh;
}

class PlyReader {
public:
    explicit PlyReader(std::istream& file) : file_(file) {}

    TriangleMesh read() {
        read_header();
        TriangleMesh mesh;
        for (const Element& element : elements_)
            for (std::size_t i = 0; i < element.count; ++i)
                read_item(element, mesh);
        return mesh;
    }

private:
    struct Property {
        std::string type, count_type, name;  // count_type is empty but for lists
    };
    struct Element {
        std::string name;
        std::size_t count = 0;
        std::vector<Property> properties;
    };

    void read_header() {
        for (std::string text, key; std::getline(file_, text);) {
            std::istringstream line(text);
            line >> key;
            if (key == "end_header") return;
            if (key == "format") {
                line >> key;
                if (key == "binary_big_endian") throw std::runtime_error("big-endian PLY");
                ascii_ = key == "ascii";
            } else if (key == "element") {
                elements_.emplace_back();
                line >> elements_.back().name >> elements_.back().count;
            } else if (key == "property" && !elements_.empty()) {
                Property p;
                line >> p.type;
                if (p.type == "list") line >> p.count_type >> p.type;
                line >> p.name;
                elements_.back().properties.push_back(p);
            }
        }
        throw std::runtime_error("PLY header without end");
    }

    void read_item(const Element& element, TriangleMesh& mesh) {
        Eigen::Vector3d position = Eigen::Vector3d::Zero();
        for (const Property& p : element.properties) {
            const std::size_t n = p.count_type.empty() ? 1 : std::size_t(number(p.count_type));
            std::vector<long> corners;
            for (std::size_t k = 0; k < n; ++k) {
                const double value = number(p.type);
                if (p.name.size() == 1 && p.name[0] >= 'x') position[p.name[0] - 'x'] = value;
                if (!p.count_type.empty()) corners.push_back(long(value));
            }
            if (element.name == "face") add_fan(mesh, corners);
            if (element.name == "tristrips") add_strips(mesh, corners);
        }
        if (element.name == "vertex") mesh.positions.push_back(position);
    }

    double number(const std::string& type) {
        if (ascii_) {
            double value = 0;
            file_ >> value;
            return value;
        }
        if (type == "float" || type == "float32") return binary<float>();
        if (type == "double" || type == "float64") return binary<double>();
        if (type == "int" || type == "int32") return binary<std::int32_t>();
        if (type == "uint" || type == "uint32") return binary<std::uint32_t>();
        if (type == "short" || type == "int16") return binary<std::int16_t>();
        if (type == "ushort" || type == "uint16") return binary<std::uint16_t>();
        if (type == "char" || type == "int8") return binary<std::int8_t>();
        return binary<std::uint8_t>();
    }

    template <class T>
    double binary() {
        T value{};
        file_.read(reinterpret_cast<char*>(&value), sizeof value);
        return double(value);
    }

    std::istream& file_;
    bool ascii_ = true;
    std::vector<Element> elements_;
};

}  // namespace

TriangleMesh read_mesh(const std::string& path) {
    std::istringstream content(file_content(path));
    const bool is_obj = ends_with(path, ".obj") || ends_with(path, ".obj.gz");
    TriangleMesh mesh = is_obj ? read_obj(content) : PlyReader(content).read();
    if (mesh.triangles.empty()) throw std::runtime_error("no triangles in " + path);
    return mesh;
}

std::string mesh_name(const std::string& path) {
    const std::string name = path.substr(path.find_last_of('/') + 1);
    return name.substr(0, name.find('.'));
}

}  // namespace test_meshes
