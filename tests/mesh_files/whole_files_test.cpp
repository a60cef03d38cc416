// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>

#include "sample_files.h"

using mesh_files::Format;
using mesh_files::MeshInFile;
using mesh_files::read_mesh;
using sample_files::Sample;
using sample_files::tetrahedra;

namespace {

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
        Format::Obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3/1/1 -2//2 \\\n -1\nf 2 1 4\nv 5 5 5");
    EXPECT_EQ(file.defect, "");
    ASSERT_EQ(file.mesh.triangles.size(), 2u);
    EXPECT_EQ(file.mesh.triangles[0], (laplacian_lines::Triangle{0, 1, 2}));
    EXPECT_EQ(file.mesh.triangles[1], (laplacian_lines::Triangle{1, 0, 3}));
}

/// As other programs write and read them.
TEST(WholeFiles, MayHaveMoreThanTheirFormatThenItIsSaid) {
    const auto expect = [](const char* name, const std::string& before, const std::string& behind,
                           const char* remark) {
        for (const Sample& sample : tetrahedra()) {
            if (sample.name != name) continue;
            const MeshInFile file = read_mesh(sample.format, before + sample.bytes + behind);
            EXPECT_EQ(file.defect, "") << name;
            EXPECT_EQ(file.remark, remark);
            EXPECT_NEAR(sample_files::volume(file.mesh), 4, 1e-12) << name;
        }
    };
    expect("obj", "\xef\xbb\xbf", "", "");
    expect(
        "obj", "\n$\nc 1 0 0\n", "f 1\nf\n",
        "lines skipped that are no statements of OBJ files: 2, the first is line 2, \"$\"; faces "
        "skipped that have fewer than three corners: 2");
    expect("stl", "", "of others\nsolid\nendsolid\n", "lines skipped after \"endsolid\": 1");
    for (const char* name : {"binary stl", "ply", "big ply", "off"})
        expect(name, "", "3 0 1\n",
               "its last 6 bytes, after what its header promises, are not read");
}

/// Such vertices are left out and counted later.
TEST(WholeFiles, MayHoldWhatIsNotFinite) {
    const MeshInFile file =
        read_mesh(Format::Off, "OFF\n3 1 0\nnan 0 0\n-1.#IND inf 1e-999\n1 2 3\n3 0 1 2\n");
    EXPECT_EQ(file.defect, "");
    ASSERT_EQ(file.mesh.positions.size(), 3u);
    EXPECT_TRUE(std::isnan(file.mesh.positions[0].x()));
    EXPECT_TRUE(std::isnan(file.mesh.positions[1].x()));
    EXPECT_TRUE(std::isinf(file.mesh.positions[1].y()));
    EXPECT_EQ(file.mesh.positions[1].z(), 0);
}

}  // namespace
