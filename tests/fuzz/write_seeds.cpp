// SPDX-License-Identifier: GPL-3.0-or-later
// write_seeds FOLDER: the fuzzers' first inputs. FOLDER/core/*: registered meshes; FOLDER/ply/* and
// so on: small files.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "registry.h"
#include "sample_files.h"
#include "wild_case.h"

namespace {

void write(const std::filesystem::path& file, const std::vector<std::uint8_t>& bytes) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

void write_seeds(const std::filesystem::path& folder) {
    for (const std::string& name : test_meshes::mesh_names())
        write(folder / "core" / name, wild::bytes_of(test_meshes::mesh_named(name).mesh));
    for (const sample_files::Sample& sample : sample_files::tetrahedra())
        write(folder / mesh_files::endings().at(std::size_t(sample.format)) / sample.name,
              {sample.bytes.begin(), sample.bytes.end()});
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: write_seeds FOLDER\n");
        return 1;
    }
    write_seeds(arguments[1]);
}
