// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing.h"

#include <nanobind/stl/string.h>

#include "line_drawing/make_sheet.h"
#include "line_drawing/sheet_choices.h"
#include "line_drawing/sheet_file.h"

namespace python_module {

namespace nb = nanobind;
using namespace line_drawing;

namespace {

bool is_of_files(const SheetOption& option) {
    const std::string_view key = option.row.key;
    return key == "damaged" || key == "format";
}

nb::list list_of(const Words& words) {
    nb::list list;
    for (const std::string& word : words)
        list.append(word);
    return list;
}

/// File names, and {name} without folder and extension.
void name_sources(const std::vector<SourceMesh>& sources, SheetOptions& options) {
    Words files, names;
    for (const SourceMesh& source : sources) {
        if (source.name.empty()) continue;
        files.push_back(source.name);
        names.push_back(source.name.substr(0, source.name.rfind('.')));
    }
    options.source = joined(files, ", ");
    options.title = titleOf(options.title, names);
}

}  // namespace

nb::list sheet_options() {
    nb::list rows;
    for (const SheetOption& option : sheetOptionTable()) {
        if (!option.isOf(SheetOption::Place::Command) || is_of_files(option)) continue;
        const bool is_switch = !option.switch_words.empty();
        const Words words = option.words();
        nb::dict d;
        d["key"] = option.row.key;
        d["help"] = option.row.help;
        d["kind"] = option.text                  ? "text"
                    : is_switch                  ? "boolean"
                    : option.row.choices.empty() ? "real"
                                                 : "choice";
        d["minimum"] = option.row.minimum;
        d["maximum"] = option.row.maximum;
        d["choices"] = list_of(is_switch ? Words() : words);
        d["words"] = list_of(words);
        d["command"] = option.command();
        d["default"] = option.text ? nb::cast(option.valueIn({})) : nb::cast(option.row.get({}));
        rows.append(d);
    }
    return rows;
}

Drawing draw(const DrawnMeshes& drawn, const Words& words, const std::string& ending,
             const laplacian_lines::Progress& progress) {
    const std::string file = '.' + ending;
    SheetChoices choices = readChoices(words);
    choices.file = file;
    SheetOptions options = sheetOptions(choices);
    name_sources(drawn.sources, options);
    const std::vector<std::string> of_texts = checkTexts(options, file);
    Objects objects;
    for (std::size_t i = 0; i < drawn.meshes.size(); ++i)
        objects.push_back({drawn.meshes[i], nullptr, drawn.sources[i].name});
    Sheet sheet = makeSheets(objects, {options}, progress).front();
    sheet.provenance = provenanceText(drawn.sources, words);
    sheet.remarks.insert(sheet.remarks.begin(), of_texts.begin(), of_texts.end());
    return {writeSheet(sheet, file, choices.dpi),
            sheet.size.x(),
            sheet.size.y(),
            sheet.scale,
            sheet.kernel,
            sheet.remarks};
}

}  // namespace python_module
