// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawings.h"

#include <algorithm>

#include "laplacian_lines/refinement.h"
#include "line_drawing/atomic_file.h"
#include "line_drawing/make_sheet.h"

using line_drawing::Sheet;

namespace {

std::vector<line_drawing::SourceMesh> sources_of(const std::vector<ReadMesh>& meshes) {
    std::vector<line_drawing::SourceMesh> sources;
    for (const ReadMesh& read : meshes)
        sources.push_back(read.source);
    return sources;
}

/// Says how large the objects are: scans may be in metres, and files have no unit.
void say_size(const std::vector<ReadMesh>& meshes, const CommandLine& commands) {
    Eigen::AlignedBox3d box;
    for (const ReadMesh& read : meshes)
        box.extend(line_drawing::bounds_of(read.mesh));
    if (box.isEmpty()) return;
    const double unit = commands.options.mm_per_unit;
    const Eigen::Vector3d size = unit * box.sizes();
    const bool is_given =
        std::find(commands.words.begin(), commands.words.end(), "--unit") != commands.words.end();
    const bool in_metres = line_drawing::likely_unit(box.diagonal().norm()) == line_drawing::kMetre;
    const char* advice = is_given    ? ""
                         : in_metres ? "; if it is in metres, say --unit m"
                                     : "; --unit says otherwise";
    say(stdout, (meshes.size() > 1 ? "together the objects are " : "the object is ") +
                    line_drawing::size_text(size, " x ") + " in size, with " +
                    line_drawing::in_digits(unit) + " mm to the unit of the mesh" + advice);
}

}  // namespace

ReadMesh read_and_report(const std::string& file, const CommandLine& commands) {
    ReadMesh read = read_mesh(file, commands.choices.draws_damaged);
    if (!read.remark.empty()) say(stderr, file + ": " + read.remark);
    if (!read.defect.empty()) say(stderr, file + " is drawn incomplete: " + read.defect);
    read.mesh = laplacian_lines::refined(std::move(read.mesh));
    return read;
}

std::vector<Sheet> draw_into(const std::string& file, const std::vector<ReadMesh>& meshes,
                             const CommandLine& commands) {
    Words titles, files;
    line_drawing::Objects objects;
    for (const ReadMesh& read : meshes) {
        titles.push_back(read.title);
        // a word before the name, since notes may be truncated
        files.push_back((read.defect.empty() ? "" : "incomplete: ") + read.source.name);
        objects.push_back({read.mesh, nullptr, read.file});
    }
    std::vector<line_drawing::SheetOptions> options = {commands.options};
    options[0].title = line_drawing::title_of(options[0].title, titles);
    options[0].source = line_drawing::joined(files, ", ");
    const std::vector<std::string> remarks = line_drawing::check_texts(options[0], file);
    if (commands.is_collection)
        options.push_back(line_drawing::contact_options(meshes.front().mesh, options[0]));
    std::vector<Sheet> sheets = line_drawing::make_sheets(objects, options);
    sheets[0].provenance = line_drawing::provenance_text(sources_of(meshes), commands.words);
    line_drawing::write_atomically(file, write_sheet(sheets[0], file, commands.choices.dpi));
    const std::string name = commands.is_collection ? meshes.front().file + ": " : "";
    for (const auto& all : {remarks, sheets[0].remarks})
        for (const std::string& remark : all)  // those of an object begin with its name
            say(stderr, (remark.compare(0, name.size(), name) == 0 ? "" : name) + remark);
    return sheets;
}

void draw_one(const CommandLine& commands) {
    line_drawing::check_writable(commands.drawing);
    std::vector<ReadMesh> meshes;
    for (const std::string& file : commands.meshes)
        meshes.push_back(read_and_report(file, commands));
    if (commands.like) say_what_differs(*commands.like, sources_of(meshes));
    say_size(meshes, commands);
    draw_into(commands.drawing, meshes, commands);
    say(stdout, "the drawing is " + commands.drawing);
}
