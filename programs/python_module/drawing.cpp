// SPDX-License-Identifier: GPL-3.0-or-later
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include "arrays.h"
#include "laplacian_lines/refinement.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/sheet_choices.h"
#include "line_drawing/sheet_file.h"

namespace python_module {

namespace nb = nanobind;
using namespace nb::literals;
using namespace line_drawing;

namespace {

const char* kind_of(const SheetOption& option) {
    if (option.row.text) return "text";
    if (!option.switch_words.empty()) return "boolean";
    return option.row.choices.empty() ? "real" : "choice";
}

}  // namespace

nb::list sheet_options() {
    nb::list rows;
    for (const SheetOption& option : sheet_option_table()) {
        const std::string key = option.row.key;
        if (!option.is_of(SheetOption::Place::Command) || key == "damaged" || key == "format")
            continue;  // of files
        const Words words = option.words();
        rows.append(dict_of("key"_a = key, "help"_a = option.row.help, "kind"_a = kind_of(option),
                            "minimum"_a = option.row.minimum, "maximum"_a = option.row.maximum,
                            "choices"_a = list_of(option.switch_words.empty() ? words : Words()),
                            "words"_a = list_of(words), "command"_a = option.command(),
                            "default"_a = option.row.text ? nb::cast(option.value_in({}))
                                                          : nb::cast(option.row.get({}))));
    }
    return rows;
}

nb::dict draw(const nb::list& meshes, const Words& words, const std::string& ending) {
    std::vector<SourceMesh> sources;
    std::vector<laplacian_lines::TriangleMesh> read;
    Words files, names;
    for (const nb::handle mesh : meshes) {
        const auto [positions, triangles, file, hash] =
            nb::cast<std::tuple<Positions, Triangles, std::string, std::string>>(mesh);
        read.push_back(mesh_of(positions, triangles));
        sources.push_back({file, hash});
        if (file.empty()) continue;
        files.push_back(file);
        names.push_back(file.substr(0, file.rfind('.')));
    }
    const std::string format = '.' + ending;
    SheetChoices choices = read_choices(words);
    choices.file = format;
    SheetOptions options = sheet_options(choices);
    options.source = joined(files, ", ");
    options.title = title_of(options.title, names);
    const std::vector<std::string> of_texts = check_texts(options, format);
    Objects objects;
    for (std::size_t i = 0; i < read.size(); ++i)
        objects.push_back({read[i], nullptr, sources[i].name});
    Sheet sheet;
    const std::string content = unlocked([&](const laplacian_lines::Progress& progress) {
        for (laplacian_lines::TriangleMesh& mesh : read)
            mesh = laplacian_lines::refined(std::move(mesh), progress);
        sheet = make_sheets(objects, {options}, progress).front();
        sheet.provenance = provenance_text(sources, words);
        return write_sheet(sheet, format, choices.dpi);
    });
    sheet.remarks.insert(sheet.remarks.begin(), of_texts.begin(), of_texts.end());
    return dict_of("content"_a = nb::bytes(content.data(), content.size()),
                   "paper"_a = nb::make_tuple(sheet.size.x(), sheet.size.y()),
                   "scale"_a = sheet.scale, "kernel"_a = sheet.kernel,
                   "remarks"_a = nb::tuple(list_of(sheet.remarks)));
}

}  // namespace python_module
