// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_files.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace sample_files {
namespace {

using mesh_files::Format;

constexpr std::array<std::array<int, 3>, 4> kCorners = {
    {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}}};
constexpr std::array<std::array<int, 3>, 4> kFaces = {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

const std::string kObj =
    "# of a test\nmtllib none.mtl\nv 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 4\nvn 0 0 1\nusemtl a\n"
    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::string kOff =
    "OFF\n# of a test\n4 4 6\n0 0 0\n2 0 0\n0 3 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string stl_text() {
    std::string text = "solid of a test\n";
    for (const auto& face : kFaces) {
        text += " facet normal 0 0 nan\n  outer loop\n";
        for (const int corner : face) {
            const auto& c = kCorners[std::size_t(corner)];
            text += "   vertex " + std::to_string(c[0]) + ' ' + std::to_string(c[1]) + ' ' +
                    std::to_string(c[2]) + '\n';
        }
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid of a test\n";
}

std::string stl_binary(const std::string& head) {
    std::string bytes = head + std::string(80 - head.size(), ' ') + packed(std::uint32_t(4));
    for (const auto& face : kFaces) {
        bytes += std::string(12, '\0');
        for (const int corner : face)
            for (const int coordinate : kCorners[std::size_t(corner)])
                bytes += packed(float(coordinate));
        bytes += std::string(2, '\0');
    }
    return bytes;
}

std::string ply_head(const std::string& format, const std::string& faces_are) {
    return "ply\nformat " + format +
           " 1.0\ncomment of a test\nelement vertex 4\nproperty float x\nproperty double y\n"
           "property uchar red\nproperty float z\n" +
           faces_are + "end_header\n";
}
const std::string kFaceLists =
    "element face 4\nproperty list char float texcoord\nproperty list uchar int vertex_indices\n"
    "property short flags\n";

const std::string kPlyVertices = "0 0 255 0\n2 0 255 0\n0 3 255 0\n0 0 255 4\n";
const std::string kPlyFaces = "2 .5 1 3 0 2 1 -7\n0 3 0 1 3 0\n1 0 3 0 3 2 0\n0 3 1 2 3 0\n";

std::string ply_binary(bool big) {
    std::string bytes = ply_head(big ? "binary_big_endian" : "binary_little_endian", kFaceLists);
    for (const auto& c : kCorners)
        bytes += packed(float(c[0]), big) + packed(double(c[1]), big) + '\xff' +
                 packed(float(c[2]), big);
    for (const auto& face : kFaces) {
        bytes += packed(std::uint8_t(1)) + packed(0.5f, big) + packed(std::uint8_t(3));
        for (const int corner : face)
            bytes += packed(std::int32_t(corner), big);
        bytes += packed(std::int16_t(-7), big);
    }
    return bytes;
}

}  // namespace

const std::vector<Sample>& tetrahedra() {
    static const std::vector<Sample> all = {
        {"obj", Format::Obj, kObj},
        {"off", Format::Off, kOff},
        {"off on a line", Format::Off,
         "OFF4 4 6 0 0 0 2 0 0 0 3 0 0 0 4 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3"},
        {"off over lines", Format::Off,
         "NOFF # of a test\n4\n4 6\n0 0 0\n0 0 1 2 0 0\n0 0 1\n0 3 0 0\n0 1 0 0 4 0 0 1\n"
         "3 0\n2 1 255 0\n3 0 1 3\n3\n0 3 2\n3 1 2 3 .5\n"},
        {"off of MeshLab", Format::Off,
         "CSTOFF\n4 4 0\n0 0 0 255 0 0 255 0 0 \n2 0 0 255 0 0 255 1 0 \n0 3 0 0 0 0 255 0 1 \n"
         "0 0 4 0 0 0 255 1 1 \n3 0 2 1 \n3 0 1 3 \n3 0 3 2 \n3 1 2 3 \n"},
        {"stl", Format::Stl, stl_text()},
        {"binary stl", Format::Stl, stl_binary("of a test")},
        {"binary stl of a solid", Format::Stl, stl_binary("solid of a test")},
        {"ply", Format::Ply, ply_head("ascii", kFaceLists) + kPlyVertices + kPlyFaces},
        {"little ply", Format::Ply, ply_binary(false)},
        {"big ply", Format::Ply, ply_binary(true)},
        {"ply of strips", Format::Ply,  // 0 2 1 3 is 0 2 1 and 1 2 3
         ply_head("ascii", "element tristrips 1\nproperty list int int vertex_indices\n") +
             kPlyVertices + "12 0 2 1 3 -1 0 1 3 -1 0 3 2\n"}};
    return all;
}

double volume(const laplacian_lines::TriangleMesh& mesh) {
    double sum = 0;
    for (const laplacian_lines::Triangle& t : mesh.triangles)
        sum += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
    return sum;
}

bool is_sound(const laplacian_lines::TriangleMesh& mesh) {
    return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
        return std::all_of(triangle.begin(), triangle.end(),
                           [&](std::uint32_t v) { return v < mesh.positions.size(); });
    });
}

}  // namespace sample_files
