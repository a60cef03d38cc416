// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <clocale>
#include <cmath>
#include <stdexcept>

#include "sample_files.h"

using Eigen::Vector3d;
using laplacian_lines::Triangle;
using mesh_files::Format;
using mesh_files::MeshInFile;
using mesh_files::read_mesh;
using sample_files::packed;
using sample_files::Sample;
using sample_files::tetrahedra;
using Polygon = std::vector<Vector3d>;

namespace {

const Sample& tetrahedron(const std::string& name) {
    for (const Sample& sample : tetrahedra())
        if (sample.name == name) return sample;
    throw std::out_of_range(name);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

TEST(WholeFiles, HoldATetrahedron) {
    for (const Sample& sample : tetrahedra()) {
        const MeshInFile file = read_mesh(sample.format, sample.bytes);
        EXPECT_EQ(file.defect + file.remark, "") << sample.name;
        ASSERT_TRUE(sample_files::is_sound(file.mesh)) << sample.name;
        EXPECT_EQ(file.mesh.triangles.size(), 4u) << sample.name;
        EXPECT_NEAR(sample_files::volume(file.mesh), 4, 1e-12) << sample.name;
    }
}

TEST(WholeFiles, HaveAnyEndsOfLines) {
    for (const Sample& sample : tetrahedra()) {
        if (sample.bytes.find('\0') != std::string::npos) continue;
        for (const char* end : {"\r\n", "\r", " \n", "\n\n"}) {
            const MeshInFile file = read_mesh(sample.format, replaced(sample.bytes, "\n", end));
            if (sample.format == Format::Ply && std::string(end) == "\n\n") continue;
            EXPECT_EQ(file.defect, "") << sample.name;
            EXPECT_NEAR(sample_files::volume(file.mesh), 4, 1e-12) << sample.name;
        }
    }
}

/// Some locales write 0,5.
TEST(WholeFiles, DoNotDependOnTheLocale) {
    const char* const before = std::setlocale(LC_ALL, nullptr);
    const std::string name = before ? before : "C";
    std::setlocale(LC_ALL, "de_DE.UTF-8");  // if it is there
    const MeshInFile file =
        read_mesh(Format::Obj, "v 0.5 +1.5e0 -.25\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::setlocale(LC_ALL, name.c_str());
    EXPECT_EQ(file.defect, "");
    EXPECT_EQ(file.mesh.positions.at(0), Eigen::Vector3d(0.5, 1.5, -0.25));
}

TEST(WholeFiles, OfObjMayCountVerticesBackAndJoinLines) {
    const MeshInFile file = read_mesh(
        Format::Obj, "#C:\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3/1/1 -2//2 \\\n -1\nf 2 1 4\nv 5 5 5");
    EXPECT_EQ(file.defect, "");
    ASSERT_EQ(file.mesh.triangles.size(), 2u);
    EXPECT_EQ(file.mesh.triangles[0], (laplacian_lines::Triangle{0, 1, 2}));
    EXPECT_EQ(file.mesh.triangles[1], (laplacian_lines::Triangle{1, 0, 3}));
}

TEST(WholeFiles, OfStlMayHaveNoEndsOfFacets) {
    const std::string whole = tetrahedron("stl").bytes, bytes = replaced(whole, " endfacet\n", "");
    EXPECT_EQ(bytes.size(), whole.size() - 4 * 10);
    const MeshInFile file = read_mesh(Format::Stl, bytes);
    EXPECT_EQ(file.defect, "");
    EXPECT_NEAR(sample_files::volume(file.mesh), 4, 1e-6);
}

/// As other programs write and read them.
TEST(WholeFiles, MayHaveMoreThanTheirFormatThenItIsSaid) {
    const auto expect = [](const char* name, const std::string& before, const std::string& behind,
                           const char* remark) {
        const Sample& sample = tetrahedron(name);
        const MeshInFile file = read_mesh(sample.format, before + sample.bytes + behind);
        EXPECT_EQ(file.defect, "") << name;
        EXPECT_EQ(file.remark, remark);
        EXPECT_NEAR(sample_files::volume(file.mesh), 4, 1e-12) << name;
    };
    expect("obj", "\xef\xbb\xbf", "", "");
    expect(
        "obj", "\n$\nc 1 0 0\n", std::string("f 1\nf\n\0\0", 8),
        "lines skipped that are no statements of OBJ files: 2, the first is line 2, \"$\"; faces "
        "skipped that have fewer than three corners: 2");
    expect("stl", "", "of others\nsolid\nendsolid\n", "lines skipped after \"endsolid\": 1");
    expect("stl", "", "solidb\nendsolid\n", "");
    for (const char* name : {"binary stl", "ply", "big ply", "off"})
        expect(name, "", "3 0 1\n",
               "its last 6 bytes, after what its header promises, are not read");
}

// ---- damage is reported, or nothing is lost

bool is_whole(const MeshInFile& file) {
    return file.mesh.triangles.size() == 4 && std::abs(sample_files::volume(file.mesh) - 4) < 1e-6;
}
bool is_told(const MeshInFile& file) {
    return !file.defect.empty() || !file.remark.empty() || is_whole(file);
}

/// OBJ has no counts.
TEST(DamagedFiles, ThatAreCutAnywhereSaySo) {
    for (const Sample& sample : tetrahedra()) {
        if (sample.format == Format::Obj) continue;
        for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
            const MeshInFile file = read_mesh(sample.format, sample.bytes.substr(0, size));
            ASSERT_TRUE(sample_files::is_sound(file.mesh));
            EXPECT_TRUE(is_told(file)) << sample.name << " of " << size << " bytes";
        }
    }
}

TEST(DamagedFiles, WithoutAWordSaySo) {
    for (const Sample& sample : tetrahedra()) {
        if (sample.bytes.find('\0') != std::string::npos) continue;
        const char* const blanks = " \n";
        for (std::size_t at = 0, end = 0; end != std::string::npos && at != std::string::npos;
             at = sample.bytes.find_first_not_of(blanks, end)) {
            end = sample.bytes.find_first_of(blanks, at);
            std::string bytes = sample.bytes;
            bytes.erase(at, end - at);
            const MeshInFile file = read_mesh(sample.format, bytes);
            ASSERT_TRUE(sample_files::is_sound(file.mesh));
            EXPECT_TRUE(is_told(file)) << sample.name << " without the word at " << at;
        }
    }
}

TEST(DamagedFiles, SayWhatAndWhere) {
    const auto defect = [](Format format, const std::string& bytes) {
        return read_mesh(format, bytes).defect;
    };
    EXPECT_EQ(defect(Format::Obj, "v 0 0 0\n\nv 1 x 0\n"), "line 3: \"x\" is not a number");
    EXPECT_EQ(defect(Format::Obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2"),
              "line 5: it ends in the middle of a line");
    EXPECT_EQ(defect(Format::Obj, "v 0 0\n"), "line 1: a vertex has 2 of three coordinates");
    EXPECT_EQ(defect(Format::Obj, "v 0 0 0\nf 1 1 2\n\n"), "line 2: a face names vertex 2 of 1");
    EXPECT_EQ(defect(Format::Obj, "v 0 0 0\nf 1 1 5000000000\n"),
              "line 2: a face names vertex \"5000000000\" of 1");
    EXPECT_EQ(defect(Format::Off, "OFF\n1 1 0\n0 0 0\n3 0 0 1\n"),
              "line 4: a face names vertex 1, counted from 0, of 1");
    EXPECT_EQ(defect(Format::Obj, std::string("v\0 \0", 4)),
              "it is text in UTF-16; save it as UTF-8 or ASCII");
    EXPECT_EQ(defect(Format::Obj, "version https://git-lfs.github.com/spec/v1\noid sha256:0\n"),
              "it is a pointer of Git LFS to the mesh; \"git lfs pull\" fetches that");
    EXPECT_EQ(defect(Format::Stl, "solid a\nfacet normal 0 0\n"),
              "line 2: it ends without \"endsolid\"");
    EXPECT_EQ(defect(Format::Stl, std::string(80, '\0') + packed(std::uint32_t(2))),
              "it has 84 bytes, but 2 triangles take 184");
    EXPECT_EQ(defect(Format::Ply,
                     "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty "
                     "float y\nproperty float z\nend_header\n0 0 0\n0 y 0\n"),
              "line 9: \"y\" is not a number, in vertex 2 of 2");
    EXPECT_NE(defect(Format::Ply,
                     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty "
                     "float y\nproperty float z\nelement face 1\nproperty list uchar float "
                     "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1.9 2\n"),
              "");
}

/// Promises of a header are not trusted.
TEST(DamagedFiles, TakeNoMoreMemoryThanTheyHaveBytes) {
    const std::string many = std::to_string(4000000000000000000ll);
    for (const char* format : {"ascii", "binary_little_endian"}) {
        const MeshInFile file = read_mesh(
            Format::Ply,
            std::string("ply\nformat ") + format + " 1.0\nelement nothing " + many +
                "\nelement vertex " + many +
                "\nproperty float x\nproperty float y\nproperty float z\nelement face " + many +
                "\nproperty list uint int vertex_indices\nend_header\n" + "0 0 0 1 1 1 2 2");
        EXPECT_NE(file.defect, "");
        EXPECT_LT(file.mesh.positions.capacity(), 100u);
        EXPECT_LT(file.mesh.triangles.capacity(), 100u);
    }
    EXPECT_NE(read_mesh(Format::Off, "OFF\n" + many + ' ' + many + " 0\n").defect, "");
    EXPECT_NE(read_mesh(Format::Stl, std::string(80, ' ') + packed(~std::uint32_t(0))).defect, "");
}

// ---- faces of more than three corners

MeshInFile file_of(const Polygon& polygon) {
    std::string text = "OFF\n" + std::to_string(polygon.size()) + " 1 0\n", face;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        char line[100];
        std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", polygon[i].x(), polygon[i].y(),
                      polygon[i].z());
        text += line;
        face += ' ' + std::to_string(i);
    }
    return read_mesh(Format::Off, text + std::to_string(polygon.size()) + face + '\n');
}

/// Of triangles along the normal, less that of flipped ones, and of all.
struct Areas {
    double along = 0, all = 0;
};
Areas areas_of(const Polygon& polygon, const Vector3d& normal) {
    const MeshInFile file = file_of(polygon);
    EXPECT_EQ(file.defect, "");
    EXPECT_EQ(file.mesh.triangles.size(), polygon.size() - 2);
    Areas areas;
    for (const Triangle& t : file.mesh.triangles) {
        const Vector3d area =
            (polygon[t[1]] - polygon[t[0]]).cross(polygon[t[2]] - polygon[t[0]]) / 2;
        areas.along += area.dot(normal);
        areas.all += area.norm();
    }
    return areas;
}

/// A gear across the normal: every second corner is on the radius `inner`, the others on 1.
Polygon gear(int corners, double inner, const Vector3d& normal) {
    const Vector3d right = normal.unitOrthogonal(), up = normal.cross(right);
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::acos(-1.) * i / corners, r = i % 2 ? inner : 1;
        polygon.push_back(Vector3d(5, 6, 7) + r * (std::cos(angle) * right + std::sin(angle) * up));
    }
    return polygon;
}

TEST(Polygons, AreFilledByTheirTrianglesWithoutOverlaps) {
    const Vector3d normal = Vector3d(1, 2, 3).normalized();
    for (const int corners : {4, 6, 12, 100})
        for (const double inner : {0.1, 0.9, 1.0}) {
            const Areas areas = areas_of(gear(corners, inner, normal), normal);
            const double expected = corners * inner * std::sin(2 * std::acos(-1.) / corners) / 2;
            EXPECT_NEAR(areas.along, expected, 1e-9) << corners << ' ' << inner;
            EXPECT_NEAR(areas.all, expected, 1e-9) << corners << ' ' << inner;
        }
}

TEST(Polygons, OfAnyFormHaveTwoTrianglesFewerThanCorners) {
    const Polygon crossed = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    const Polygon flat = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}};
    const Polygon point(6, Vector3d(1, 2, 3));
    const Polygon beyond = {
        {0, 0, 0}, {NAN, 0, 0}, {1, INFINITY, 0}, {1e300, 1e300, -1e300}, {0, 1, 0}};
    for (const Polygon& polygon : {crossed, flat, point})
        areas_of(polygon, Vector3d::UnitZ());
    const MeshInFile file = file_of(beyond);
    EXPECT_EQ(file.mesh.triangles.size(), beyond.size() - 2);
    EXPECT_NE(file.defect.find("without finite coordinates"), std::string::npos) << file.defect;
}

/// A square along the diagonal that leaves less area, a gable roof along its ridge.
TEST(Polygons, ThatAreBentAreCutAlongTheBend) {
    Polygon valley = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, .5}};
    Polygon gable = {{0, 0, 0}, {1, 0, .5}, {2, 0, 0}, {2, 3, 0}, {1, 3, .5}, {0, 3, 0}};
    const double less = (std::sqrt(3) + std::sqrt(1.5)) / 2;  // the other diagonal leaves 1.5
    for (int begin = 0; begin < 6; ++begin) {
        EXPECT_NEAR(areas_of(valley, Vector3d::UnitZ()).all, less, 1e-12) << begin;
        EXPECT_NEAR(areas_of(gable, Vector3d::UnitZ()).all, 6 * std::sqrt(1.25), 1e-12) << begin;
        for (Polygon* polygon : {&valley, &gable})
            std::rotate(polygon->begin(), polygon->begin() + 1, polygon->end());
    }
}

TEST(Polygons, OfManyCornersAreQuickOrRefused) {
    EXPECT_EQ(file_of(gear(100000, 1, Vector3d::UnitZ())).defect, "");
    EXPECT_NE(file_of(gear(100000, 0.99, Vector3d::UnitZ())).defect, "");
}

}  // namespace
