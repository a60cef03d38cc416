// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_file.h"

#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "mesh_files/mesh_file.h"

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

/// Ignores ".gz".
mesh_files::Format format_of(const std::string& path) {
    const std::string name = ends_with(path, ".gz") ? path.substr(0, path.size() - 3) : path;
    const auto format = mesh_files::format_of(name.substr(name.rfind('.') + 1));
    if (!format) throw std::runtime_error("no mesh: " + path);
    return *format;
}

}  // namespace

TriangleMesh read_mesh(const std::string& path) {
    mesh_files::MeshInFile file = mesh_files::read_mesh(format_of(path), file_content(path));
    if (!file.defect.empty()) throw std::runtime_error(path + ": " + file.defect);
    if (file.mesh.triangles.empty()) throw std::runtime_error("no triangles in " + path);
    return std::move(file.mesh);
}

std::string mesh_name(const std::string& path) {
    const std::string name = path.substr(path.find_last_of('/') + 1);
    return name.substr(0, name.find('.'));
}

}  // namespace test_meshes
