// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_files/mesh_file.h"

#include <array>

#include "readers.h"
#include "text.h"

namespace mesh_files {
namespace {

struct Reader {
    const char* ending;
    void (*read)(std::string_view bytes, MeshBuilder& mesh);
};
/// By Format.
constexpr std::array<Reader, 4> kReaders = {
    {{"ply", read_ply}, {"stl", read_stl}, {"obj", read_obj}, {"off", read_off}}};

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
        kReaders[std::size_t(format)].read(bytes, builder);
    } catch (const Defect& defect) {
        file.defect = defect.what;
    }
    file.mesh = builder.finish(file.defect);
    return file;
}

}  // namespace mesh_files
