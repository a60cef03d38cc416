// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_files/mesh_file.h"

#include <algorithm>
#include <array>

#include "mesh_builder.h"
#include "text.h"

namespace mesh_files {
namespace {

struct Reader {
    const char* ending;
    std::string (*read)(std::string_view bytes, MeshBuilder& mesh);
};
/// By Format.
constexpr std::array<Reader, 4> kReaders = {
    {{"ply", read_ply}, {"stl", read_stl}, {"obj", read_obj}, {"off", read_off}}};

constexpr std::string_view kLfsPointer = "version https://git-lfs";
constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";

/// With or without a byte order mark, for text in ASCII.
bool is_utf16(std::string_view bytes) {
    const std::string_view begin = bytes.substr(0, 2);
    if (begin == "\xff\xfe" || begin == "\xfe\xff") return true;
    const auto is_letter = [&](std::size_t i) { return bytes[i] >= ' ' && bytes[i] < '\x7f'; };
    return bytes.size() > 3 && ((is_letter(0) && !bytes[1] && is_letter(2) && !bytes[3]) ||
                                (!bytes[0] && is_letter(1) && !bytes[2] && is_letter(3)));
}

std::string joined(const std::string& remark, std::size_t skipped_faces) {
    if (skipped_faces == 0) return remark;
    return (remark.empty() ? "" : remark + "; ") +
           "faces skipped that have fewer than three corners: " + std::to_string(skipped_faces);
}

/// The defect of a mesh with corners that are not finite, or nothing.
std::string defect_of(const laplacian_lines::TriangleMesh& mesh) {
    const auto is_nowhere = [&](std::uint32_t corner) {
        return !mesh.positions[corner].allFinite();
    };
    const auto wrong = std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                     [&](const laplacian_lines::Triangle& t) {
                                         return std::any_of(t.begin(), t.end(), is_nowhere);
                                     });
    if (wrong == 0) return {};
    return std::to_string(wrong) + " of " + std::to_string(mesh.triangles.size()) +
           " triangles have corners without finite coordinates";
}

}  // namespace

std::optional<Format> format_of(std::string_view ending) {
    for (std::size_t i = 0; i < kReaders.size(); ++i)
        if (ending == kReaders[i].ending) return Format(i);
    return {};
}

std::vector<std::string> endings() {
    std::vector<std::string> all;
    for (const Reader& reader : kReaders)
        all.emplace_back(reader.ending);
    return all;
}

MeshInFile read_mesh(Format format, std::string_view bytes) {
    MeshBuilder builder;
    MeshInFile file;
    try {
        if (bytes.empty()) throw Defect{"it is empty"};
        if (bytes.substr(0, kLfsPointer.size()) == kLfsPointer)
            throw Defect{"it is a pointer of Git LFS to the mesh; \"git lfs pull\" fetches that"};
        if (is_utf16(bytes)) throw Defect{"it is text in UTF-16; save it as UTF-8 or ASCII"};
        if (bytes.substr(0, kUtf8Mark.size()) == kUtf8Mark) bytes.remove_prefix(kUtf8Mark.size());
        const std::string remark = kReaders[std::size_t(format)].read(bytes, builder);
        file.remark = joined(remark, builder.skipped_faces());
    } catch (const Defect& defect) {
        file.defect = defect.what;
    }
    file.mesh = builder.finish(file.defect);
    if (file.defect.empty()) file.defect = defect_of(file.mesh);
    return file;
}

}  // namespace mesh_files
