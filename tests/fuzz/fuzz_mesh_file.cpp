// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of a file of FORMAT, a name of mesh_files::Format.
#include <cstdio>
#include <cstdlib>

#include "sample_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const mesh_files::MeshInFile file = mesh_files::read_mesh(
        mesh_files::Format::FORMAT, {reinterpret_cast<const char*>(bytes), size});
    if (sample_files::is_sound(file.mesh)) return 0;
    std::fprintf(stderr, "mesh_file: a triangle without vertices\n");
    std::abort();
}
