// SPDX-License-Identifier: GPL-3.0-or-later
// Damage is reported, or nothing is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sample_files.h"
#include "text.h"

using mesh_files::Format;
using mesh_files::MeshInFile;
using mesh_files::read_mesh;
using sample_files::packed;
using sample_files::Sample;
using sample_files::tetrahedra;

namespace {

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
        std::string_view rest = sample.bytes;
        while (!rest.empty()) {
            const std::string_view word = mesh_files::take_word(rest);
            const auto at = std::size_t(word.data() - sample.bytes.data());
            std::string bytes = sample.bytes;
            bytes.erase(at, word.size());
            const MeshInFile file = read_mesh(sample.format, bytes);
            ASSERT_TRUE(sample_files::is_sound(file.mesh));
            EXPECT_TRUE(is_told(file)) << sample.name << " without \"" << word << "\" at " << at;
        }
    }
}

TEST(DamagedFiles, KeepWhatComesBefore) {
    for (const Sample& sample : tetrahedra()) {
        const std::size_t near_end = sample.bytes.size() - (sample.name == "stl" ? 100 : 12);
        const MeshInFile file = read_mesh(sample.format, sample.bytes.substr(0, near_end));
        const bool has_lines =
            sample.name != "ply of strips" && sample.name.substr(0, 5) != "off o";
        EXPECT_GE(file.mesh.triangles.size(), has_lines ? 2u : 0u) << sample.name;
    }
}

TEST(DamagedFiles, SayWhatAndWhere) {
    const auto defect = [](Format format, const std::string& bytes) {
        return read_mesh(format, bytes).defect;
    };
    EXPECT_EQ(defect(Format::Obj, "v 0 0 0\n\nv 1 x 0\n"), "line 3: \"x\" is not a number");
    EXPECT_EQ(defect(Format::Obj, "v 0 0\n"), "line 1: a vertex has 2 of three coordinates");
    EXPECT_EQ(defect(Format::Obj, "v 0 0 0\nf 1 1 2\n\n"), "line 2: a face names vertex 2 of 1");
    EXPECT_EQ(defect(Format::Obj, "7 0 0 0\n"), "line 1: \"7\" is not a statement of OBJ files");
    EXPECT_EQ(defect(Format::Off, "OFF\n1 0 0\n"), "line 2: it ends before vertex 1 of 1");
    EXPECT_EQ(defect(Format::Off, "OFF BINARY\n"),
              "line 1: binary OFF files are not read; save it as text, or as PLY");
    EXPECT_EQ(defect(Format::Off, "OFF\n1 1 0\n0 0 0\n3 0 0 1\n"),
              "line 4: a face names vertex 1, counted from 0, of 1");
    EXPECT_EQ(defect(Format::Obj, std::string("v\0 \0", 4)),
              "it is text in UTF-16; save it as UTF-8 or ASCII");
    EXPECT_EQ(defect(Format::Stl, ""), "it is empty");
    EXPECT_EQ(defect(Format::Stl, "solid a\nfacet normal 0 0\n"),
              "line 2: it ends without \"endsolid\"");
    EXPECT_EQ(defect(Format::Stl, std::string(80, '\0') + packed(std::uint32_t(2))),
              "it has 84 bytes, but 2 triangles take 184");
    EXPECT_EQ(defect(Format::Stl, "solid" + std::string(75, ' ') + packed(std::uint32_t(0))),
              "");  // of no triangles, and no text
    EXPECT_EQ(defect(Format::Ply, "ply\nformat ascii 1.0\nelement vertex 1\nend_header\n"),
              "line 4: its vertices have no x");
    EXPECT_EQ(defect(Format::Ply,
                     "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty "
                     "float y\nproperty float z\nend_header\n0 0 0\n0 y 0\n"),
              "line 9: \"y\" is not a number, in vertex 2 of 2");
    EXPECT_EQ(defect(Format::Ply, "PLX\n"), "line 1: it does not begin with \"ply\"");
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

/// Bytes changed, removed, inserted and moved, some thousand times per sample.
TEST(DamagedFiles, OfAnyKindAreReadSoundly) {
    std::mt19937 random(24);
    const std::string words[] = {"-1",    "4294967295", "4294967296",
                                 "1e309", "nan",        " ",
                                 "\n",    "f",          "999999999999999999999",
                                 "\\\n",  "#",          "list",
                                 "facet", "end_header"};
    for (const Sample& sample : tetrahedra())
        for (int round = 0; round < 3000; ++round) {
            std::string bytes = sample.bytes;
            for (unsigned change = 0; change <= random() % 4; ++change) {
                const std::size_t at = random() % (bytes.size() + 1);
                const std::size_t count = random() % 16;
                switch (random() % 5) {
                    case 0:
                        bytes.erase(at, count);
                        break;
                    case 1:
                        bytes.insert(at, words[random() % std::size(words)]);
                        break;
                    case 2:
                        bytes.insert(at, bytes.substr(random() % (bytes.size() + 1), count));
                        break;
                    case 3:
                        std::reverse(bytes.begin() + std::ptrdiff_t(at), bytes.end());
                        break;
                    default:
                        if (at < bytes.size()) bytes[at] = char(random());
                }
            }
            ASSERT_TRUE(sample_files::is_sound(read_mesh(sample.format, bytes).mesh))
                << sample.name << " in round " << round;
        }
}

}  // namespace
