// SPDX-License-Identifier: GPL-3.0-or-later
// lines MESH.obj LINES.obj: the lines of a triangle mesh, as one sees it from far away along -z.
#include <laplacian_lines/line_extractor.h>
#include <laplacian_lines/line_visibility.h>
#include <laplacian_lines/precompute.h>

#include <fstream>
#include <iostream>
#include <sstream>

using namespace laplacian_lines;

TriangleMesh read_obj(std::istream& file) {
    TriangleMesh mesh;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "v") {
            Eigen::Vector3d& position = mesh.positions.emplace_back();
            words >> position.x() >> position.y() >> position.z();
        } else if (word == "f") {
            for (std::uint32_t& corner : mesh.triangles.emplace_back())
                if (words >> word) corner = std::uint32_t(std::stoul(word) - 1);  // "7" or "7/1/2"
        }
    }
    return mesh;
}

void write_obj(const LineSet& lines, std::ostream& file) {
    for (const LinePoint& point : lines.points)
        file << "v " << lines.position(point).transpose() << '\n';
    for (const Polyline& line : lines.lines) {
        file << 'l';
        for (std::uint32_t i = 1; i <= line.count; ++i)
            file << ' ' << line.first + i;
        file << '\n';
    }
}

int main(int argc, char** argv) try {
    if (argc != 3) throw std::invalid_argument("name two files: MESH.obj LINES.obj");
    std::ifstream mesh_file(argv[1]);
    const TriangleMesh mesh = read_obj(mesh_file);
    const Field field = precompute(mesh);
    const View view = View::orthographic({0, 0, 1});
    const LineStyle style;
    ExtractionScratch scratch;
    const LineSet lines = extract_on_surface(LineExtractor(mesh, field), view, style, scratch);
    std::ofstream line_file(argv[2]);
    write_obj(LineVisibility(mesh).parts(view, {lines}, {style.shows, style.line_smoothing}).seen,
              line_file);
    return line_file.flush() ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "lines: " << error.what() << '\n';
    return 1;
}
