// SPDX-License-Identifier: GPL-3.0-or-later
#include "obj_reading.h"

#include <stdexcept>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

laplacian_lines::TriangleMesh readObj(const std::string& file) {
    tinyobj::ObjReader reader;
    if (!reader.ParseFromFile(file)) throw std::runtime_error(reader.Error());
    laplacian_lines::TriangleMesh mesh;
    const std::vector<double>& vertices = reader.GetAttrib().vertices;
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3)
        mesh.positions.emplace_back(vertices[i], vertices[i + 1], vertices[i + 2]);
    for (const tinyobj::shape_t& shape : reader.GetShapes())
        for (std::size_t i = 0; i + 2 < shape.mesh.indices.size(); i += 3) {
            laplacian_lines::Triangle& triangle = mesh.triangles.emplace_back();
            for (std::size_t k = 0; k < 3; ++k)
                triangle[k] = std::uint32_t(shape.mesh.indices[i + k].vertex_index);
        }
    return mesh;
}
