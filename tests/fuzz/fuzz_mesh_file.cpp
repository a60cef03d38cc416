// SPDX-License-Identifier: GPL-3.0-or-later
// A file of FORMAT, as in mesh_files::Format, from bytes, and its measured drawing.
#include <cstdio>
#include <cstdlib>

#include "laplacian_lines/error.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/sheet_file.h"
#include "sample_files.h"

namespace {

constexpr std::size_t kMostTriangles = 60;  // rays meet most of those that lie in one another

[[noreturn]] void refuse(const char* what) {
    std::fprintf(stderr, "mesh_file: %s\n", what);
    std::abort();
}

/// Either refused, or drawn with finite numbers.
void draw(const laplacian_lines::TriangleMesh& mesh) {
    line_drawing::SheetOptions options;
    options.views = line_drawing::parse_views("front 30,20", line_drawing::UpAxis::Y);
    options.sections = line_drawing::parse_sections("y=0.4");
    options.area = line_drawing::OutlineArea::Filled;
    try {
        const auto sheets = line_drawing::make_sheets({{mesh}}, {options});
        const std::string svg = line_drawing::write_sheet(sheets.front(), ".svg");
        for (const char* none : {"nan", "inf ", "9223372036854775"})  // the last, as thousandths
            if (svg.find(none) != svg.npos) refuse("a drawing without numbers");
        line_drawing::write_sheet(sheets.front(), ".dxf");
    } catch (const laplacian_lines::Error&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const mesh_files::MeshInFile file = mesh_files::read_mesh(
        mesh_files::Format::FORMAT, {reinterpret_cast<const char*>(bytes), size});
    if (!sample_files::is_sound(file.mesh)) refuse("a triangle without vertices");
    if (!file.mesh.triangles.empty() && file.mesh.triangles.size() <= kMostTriangles)
        draw(file.mesh);
    return 0;
}
