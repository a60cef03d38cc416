// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawings.h"

#include <algorithm>

#include "line_drawing/make_sheet.h"
#include "line_drawing/whole_file.h"

namespace {

/// What is missing of an object, if anything.
std::string lackOf(const ReadMesh& read) {
    if (!read.defect.empty()) return read.defect;
    const auto& all = read.mesh.positions;
    const auto lacking = std::count_if(all.begin(), all.end(),
                                       [](const Eigen::Vector3d& p) { return !p.allFinite(); });
    if (lacking == 0) return {};
    return std::to_string(lacking) + " of " + std::to_string(all.size()) +
           " vertices have no finite coordinates";
}

/// File names, those not drawn whole marked by a word before: notes may be cut off at the end.
std::string noteOf(const std::vector<ReadMesh>& meshes) {
    Words names;
    for (const ReadMesh& read : meshes) {
        const std::string lack = lackOf(read);
        names.push_back((lack.empty() ? "" : "incomplete: ") + read.source.name);
        if (!lack.empty()) say(stderr, read.file + " is drawn incomplete: " + lack);
    }
    return line_drawing::joined(names, ", ");
}

/// With the meshes' names.
line_drawing::SheetOptions optionsFor(const std::vector<ReadMesh>& meshes,
                                      line_drawing::SheetOptions options) {
    Words titles;
    for (const ReadMesh& read : meshes)
        titles.push_back(read.title);
    options.title = line_drawing::titleOf(options.title, titles);
    options.source = noteOf(meshes);
    return options;
}

}  // namespace

ReadMesh readAloud(const std::string& file, const CommandLine& commands) {
    ReadMesh read = readMesh(file, commands.choices.draws_damaged);
    if (!read.remark.empty()) say(stderr, file + ": " + read.remark);
    return read;
}

std::vector<line_drawing::SourceMesh> sourcesOf(const std::vector<ReadMesh>& meshes) {
    std::vector<line_drawing::SourceMesh> sources;
    for (const ReadMesh& read : meshes)
        sources.push_back(read.source);
    return sources;
}

std::vector<line_drawing::Sheet> drawInto(const std::string& file,
                                          const std::vector<ReadMesh>& meshes,
                                          const CommandLine& commands) {
    std::vector<line_drawing::SheetOptions> options = {optionsFor(meshes, commands.options)};
    const std::vector<std::string> remarks = line_drawing::checkTexts(options[0], file);
    if (commands.is_collection)
        options.push_back(line_drawing::contactOptions(meshes.front().mesh, options[0]));
    line_drawing::Objects objects;
    for (const ReadMesh& read : meshes)
        objects.push_back({read.mesh, nullptr, read.file});
    std::vector<line_drawing::Sheet> sheets = line_drawing::makeSheets(objects, options);
    sheets[0].provenance = line_drawing::provenanceText(sourcesOf(meshes), commands.words);
    line_drawing::writeWhole(file, writeSheet(sheets[0], file, commands.choices.dpi));
    for (const auto& all : {remarks, sheets[0].remarks})
        for (const std::string& remark : all)
            say(stderr, (commands.is_collection ? meshes.front().file + ": " : "") + remark);
    return sheets;
}
