// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_reading.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <future>

#include "mesh_files/mesh_file.h"
#include "sha256.h"

namespace fs = std::filesystem;
using line_drawing::Words;

namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
    laplacian_lines::refuse(file + ": " + why, laplacian_lines::ErrorCode::InvalidMesh);
}

std::optional<mesh_files::Format> format_of(const fs::path& file) {
    const std::string ending = line_drawing::lower(file.extension().u8string());
    return mesh_files::format_of(ending.substr(std::min<std::size_t>(1, ending.size())));
}

Words meshes_in(const std::string& folder) {
    Words meshes;
    std::error_code error;
    for (fs::directory_iterator entry(fs::u8path(folder), error), end; !error && entry != end;
         entry.increment(error))
        if (std::error_code none; format_of(entry->path()) && entry->is_regular_file(none))
            meshes.push_back(entry->path().u8string());
    std::sort(meshes.begin(), meshes.end());
    return meshes;
}

}  // namespace

bool is_folder(const std::string& name) {
    std::error_code none;
    return fs::is_directory(fs::u8path(name), none);
}

bool is_named_like_mesh(const std::string& name) {
    return format_of(fs::u8path(name)).has_value();
}

Words meshes_of(const Words& named) {
    Words meshes;
    for (const std::string& name : named) {
        const Words found = is_folder(name) ? meshes_in(name) : Words{name};
        if (found.empty())
            laplacian_lines::refuse("there is no mesh in the folder \"" + name + "\".");
        for (const std::string& mesh : found)
            if (std::find(meshes.begin(), meshes.end(), mesh) == meshes.end())
                meshes.push_back(mesh);
    }
    return meshes;
}

std::optional<std::string> contents_of(const std::string& name) {
    const fs::path file = fs::u8path(name);
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);  // fails for folders and devices
    if (error) return {};
    std::string bytes(size, '\0');
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(bytes.data(), std::streamsize(size))) return {};
    return bytes;
}

std::string readable(const std::string& name) {
    return line_drawing::in_utf8(line_drawing::letters_of(name));
}

ReadMesh read_mesh(const std::string& file, bool draws_damaged) {
    const std::optional<std::string> bytes = contents_of(file);
    if (!bytes) refuse(file, "there is no such file, or it cannot be read.");
    const fs::path name = fs::u8path(file).filename();
    const auto format = format_of(name);
    if (!format)
        refuse(file,
               "meshes are read from PLY, OBJ, STL and OFF files; MeshLab exports others as "
               "these.");
    auto hash = std::async(std::launch::async, [&] { return sha256_of(*bytes); });
    auto [mesh, defect, remark] = mesh_files::read_mesh(*format, *bytes);
    if (mesh.triangles.empty() && !defect.empty())
        refuse(file, "the mesh cannot be read: " + defect + '.');
    if (mesh.triangles.empty())
        refuse(file,
               "the mesh has no faces; lines are drawn on surfaces. If it is a point cloud, "
               "reconstruct one first." +
                   (remark.empty() ? "" : " Of the file, " + remark + '.'));
    if (!defect.empty() && !draws_damaged)
        refuse(file, "the file is damaged: " + defect +
                         ". With --damaged draw, what is whole of it is drawn.");
    return {file,
            std::move(mesh),
            {readable(name.u8string()), hash.get()},
            readable(name.stem().u8string()),
            defect,
            remark};
}
