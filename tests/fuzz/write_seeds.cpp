// SPDX-License-Identifier: GPL-3.0-or-later
// write_seeds FOLDER: the fuzzers' first inputs. FOLDER/precompute/* and FOLDER/extract/*:
// registered meshes and random bytes; FOLDER/ply/* and so on: small files.
#include <cstdio>
#include <filesystem>
#include <fstream>

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
    unsigned number = 0;
    for (const auto* entries : {&test_meshes::all_entries(), &test_meshes::wild_entries()})
        for (const test_meshes::MeshEntry& entry : *entries) {
            const test_meshes::TestMesh& mesh = entry.get();
            write(folder / "precompute" / mesh.name, wild::precompute_seed(mesh.mesh));
            write(folder / "precompute" / (mesh.name + "_changed"),
                  wild::precompute_seed(mesh.mesh, number));
            write(folder / "extract" / mesh.name, wild::extract_seed(mesh.mesh, number++));
        }
    for (unsigned seed = 1; seed <= 24; ++seed)
        for (const char* part : {"precompute", "extract"})
            write(folder / part / ("random_" + std::to_string(seed)),
                  test_meshes::random_bytes(seed, 20 * seed));
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
