// SPDX-License-Identifier: GPL-3.0-or-later
// outline_completeness [OPTIONS] [MESH...]
// How complete a drawing is: of the test meshes, of primitives, and of the files that are named
// (OBJ or PLY, plain or with .gz), each seen from a dozen sides. For each mesh the worst view and
// the mean of: the share of the outline, where surface and background meet, with a line within 3
// pixels of a picture of 400 x 400; the share of the lines' pixels that have neither outline nor a
// jump of depth or of the triangles' normals within 3 pixels; the share of the edges that are seen,
// of 40 degrees or more, with a line within 3 pixels. Where weight times opacity is below 0.1, a
// line does not count.
//   --only TEXT        only meshes with this in their names
//   --set KEY=VALUE    an option of the style
//   --views N, --size N, --edge-angle DEGREES
//   --pictures FOLDER  the ten with the least complete outlines, each in its worst view, as PPM:
//                      surface green, missed outline red, lines black
//   --json FILE        all figures
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "command_words.h"
#include "drawing_report.h"
#include "laplacian_lines/option_table.h"
#include "mesh_file.h"
#include "primitive_meshes.h"
#include "registry.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;

constexpr std::size_t kPictures = 10;

struct Arguments {
    MeasureOptions measures;
    std::string only, pictures, json;
    std::vector<std::string> files;
};

double number(const std::string& option, const std::string& text, double least, double most) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end || !(value >= least && value <= most))
        throw std::invalid_argument(option + " needs a number from " + std::to_string(int(least)) +
                                    " to " + std::to_string(int(most)));
    return value;
}

void set_option(const std::string& text, LineStyle& style) {
    const std::size_t sign = text.find('=');
    for (const auto& row : line_style_table())
        if (text.substr(0, sign) == row.key && sign != text.npos) {
            row.set(style, number(row.key, text.substr(sign + 1), row.minimum, row.maximum));
            return;
        }
    throw std::invalid_argument("--set needs KEY=VALUE with a key of the style, not " + text);
}

Arguments parse(int argc, char** argv) {
    Arguments result;
    const auto set = [&](const std::string& argument, const std::string& value) {
        if (argument == "--only")
            result.only = value;
        else if (argument == "--set")
            set_option(value, result.measures.style);
        else if (argument == "--views")
            result.measures.views = int(number(argument, value, 1, 1000));
        else if (argument == "--size")
            result.measures.size = int(number(argument, value, 10, 4000));
        else if (argument == "--edge-angle")
            result.measures.edge_angle = number(argument, value, 1, 180);
        else if (argument == "--pictures")
            result.pictures = value;
        else if (argument == "--json")
            result.json = value;
        else
            return false;
        return true;
    };
    result.files = files_among(argc, argv, set);
    return result;
}

/// Measures one mesh after the other, and goes on after those that cannot be.
class Measuring {
public:
    explicit Measuring(const Arguments& arguments) : arguments_(arguments) {}

    template <class Make>
    void add(const std::string& name, const char* group, bool is_sharp, Make make) {
        if (name.find(arguments_.only) == name.npos) return;
        std::fprintf(stderr, "measuring %s\n", name.c_str());
        try {
            drawings.push_back(
                {name, group, is_sharp, measure_drawing(make(), arguments_.measures)});
        } catch (const std::exception& error) {
            std::fprintf(stderr, "outline_completeness: %s: %s\n", name.c_str(), error.what());
            failed = true;
        }
    }

    std::vector<MeasuredDrawing> drawings;
    bool failed = false;

private:
    const Arguments& arguments_;
};

void measure_all(const Arguments& arguments, Measuring& measuring) {
    for (const test_meshes::MeshEntry& entry : test_meshes::all_entries())
        measuring.add(entry.name, "registered", entry.has(test_meshes::kSharp),
                      [&] { return entry.get().mesh; });
    for (const Primitive& primitive : primitive_meshes())
        measuring.add(primitive.name, "primitives", primitive.is_sharp, primitive.make);
    for (const std::string& file : arguments.files)
        measuring.add(test_meshes::mesh_name(file), "files", false,
                      [&] { return test_meshes::read_mesh(file); });
}

void write_pictures(const std::vector<MeasuredDrawing>& drawings, const std::string& folder) {
    std::filesystem::create_directories(folder);
    for (std::size_t i = 0; i < drawings.size() && i < kPictures; ++i)
        for (const DrawnView& view : drawings[i].measures.worst_drawing)
            write_picture(view, folder + "/" + drawings[i].name + ".ppm");
}

bool run(const Arguments& arguments) {
    Measuring measuring(arguments);
    measure_all(arguments, measuring);
    std::vector<MeasuredDrawing>& drawings = measuring.drawings;
    sort_by_worst(drawings);
    std::printf("%s\n%s", drawing_table(drawings).c_str(), drawing_summary(drawings).c_str());
    if (!arguments.pictures.empty()) write_pictures(drawings, arguments.pictures);
    if (!arguments.json.empty() &&
        !(std::ofstream(arguments.json) << json_report(drawing_figures(drawings)) << std::flush))
        throw std::runtime_error("cannot write " + arguments.json);
    return !measuring.failed;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(parse(argc, argv)) ? 0 : 1;
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr,
                     "outline_completeness: %s\noutline_completeness [--only TEXT] "
                     "[--set KEY=VALUE]... [--views N] [--size N] [--edge-angle DEGREES] "
                     "[--pictures FOLDER] [--json FILE] [MESH...]\n",
                     error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "outline_completeness: %s\n", error.what());
        return 1;
    }
}
