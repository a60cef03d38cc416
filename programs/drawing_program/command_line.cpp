// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <QFileInfo>
#include <algorithm>

#include "file_names.h"
#include "like.h"
#include "mesh_reading.h"
#include "sheet_painting/qt_words.h"

using line_drawing::SheetChoices;
using line_drawing::SheetOption;
using sheet_painting::inQt;
using sheet_painting::refuse;

namespace {

const char* const format = "--format";              // of a collection
const char* const contact_view = "--contact-view";  // of the processes of a collection

/// Null if the command has no such option.
const SheetOption* optionOf(const QString& word) {
    const std::vector<SheetOption>& table = line_drawing::sheetOptionTable();
    const auto found = std::find_if(table.begin(), table.end(), [&](const SheetOption& option) {
        return option.isOf(SheetOption::Place::Command) && inQt(option.command()) == word;
    });
    return found == table.end() ? nullptr : &*found;
}

/// A folder of drawings is one that is there, or whose name ends like one.
void nameFiles(const QStringList& names, bool has_format, CommandLine& result) {
    if (names.size() < 2) refuse("name two files: the drawing and the mesh; see --help.");
    result.drawing = names[0];
    result.choices.file = sheet_painting::fileName(names[0]);
    result.meshes = names.mid(1);
    result.is_collection = names[0].endsWith('/') || QFileInfo(names[0]).isDir();
    if (result.is_collection) return;
    result.meshes = meshesOf(result.meshes);
    if (has_format)
        refuse("--format is for a folder of drawings; the extension of a file sets its format.");
}

QString takeValue(QStringList& rest, const QString& option) {
    if (rest.isEmpty()) refuse(option + " needs a value; see --help.");
    return rest.takeFirst();
}

/// Takes a word, and its value with it. False if it is the name of a file.
bool takeOption(const QString& word, QStringList& rest, CommandLine& result) {
    if (word == "-h" || word == "--help") {
        result.help = true;
    } else if (word == "--version") {
        result.version = true;
    } else if (word == "--like") {
        result.like = likeOf(takeValue(rest, word));
        rest = result.like->options + rest;
    } else if (word == contact_view) {
        result.contact_view = takeValue(rest, word);
    } else if (const SheetOption* option = optionOf(word)) {
        const QString value = takeValue(rest, word);
        option->read(value.toStdString(), result.choices);
        if (word == format)
            result.format = inQt(option->valueIn(result.choices));
        else
            result.words << word << value;
    } else if (word.startsWith("--")) {
        refuse("unknown option " + word + "; see --help.");
    } else {
        return false;
    }
    return true;
}

}  // namespace

CommandLine parseCommandLine(const QStringList& arguments) {
    CommandLine result;
    SheetChoices& choices = result.choices;
    const std::string usual_views = choices.views;
    choices.views.clear();
    QStringList rest = arguments, names;
    while (!rest.isEmpty()) {
        const QString word = rest.takeFirst();
        if (word == "--")
            names << rest, rest.clear();
        else if (!takeOption(word, rest, result))
            names << word;
    }
    if (result.help || result.version) return result;
    nameFiles(names, !result.format.isEmpty(), result);
    result.format = inQt(optionOf(format)->valueIn(choices));
    if (choices.views.empty() && line_drawing::trimmed(choices.sections).empty())
        choices.views = usual_views;
    result.options = line_drawing::sheetOptions(choices);
    if (result.is_collection) return result;
    QStringList mesh_names;
    for (const QString& mesh : result.meshes)
        mesh_names << readable(QFileInfo(mesh).completeBaseName());
    result.options.title =
        inQt(result.options.title).replace("{name}", mesh_names.join(", ")).toStdString();
    return result;
}

QString usage() {
    return "laplacian-lines FILE.svg|.pdf|.dxf|.png [OPTION...] MESH|FOLDER...\n"
           "                       a measured drawing of a mesh, or of several that hide each "
           "other\n"
           "laplacian-lines FOLDER/ [OPTION...] MESH|FOLDER...\n"
           "                       one of each, and a contact sheet; what is there and unchanged "
           "is\n"
           "                       not drawn again\n"
           "\n" +
           inQt(line_drawing::sheetOptionsHelp()) +
           "  --like FILE          with the options that a drawing (SVG, PDF, DXF) was made with;\n"
           "                       others that follow count more\n"
           "  --version            of this program\n"
           "  --help               this text\n";
}
