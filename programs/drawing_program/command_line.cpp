// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <QFileInfo>

#include "file_names.h"
#include "mesh_reading.h"

namespace {

const char* const format = "--format";              // of a collection
const char* const contact_view = "--contact-view";  // of the processes of a collection

/// A folder of drawings exists, or is named like one.
void nameFiles(const QStringList& names, bool has_format, CommandLine& result) {
    if (names.size() < 2) refuse("name two files: the drawing and the mesh; see --help.");
    result.drawing = names[0];
    result.choices.file = fileName(names[0]);
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

/// Consumes an option with its value. False for the name of a file.
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
    } else if (word == format) {
        result.format = takeValue(rest, word);
    } else if (line_drawing::commandOption(word.toStdString())) {
        result.words << word << takeValue(rest, word);
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
    QStringList rest = arguments, names;
    while (!rest.isEmpty()) {
        const QString word = rest.takeFirst();
        if (word == "--")
            names << rest, rest.clear();
        else if (!takeOption(word, rest, result))
            names << word;
    }
    if (result.help || result.version) return result;
    const bool has_format = !result.format.isEmpty();
    result.choices = line_drawing::readChoices(
        inUtf8(has_format ? result.words + QStringList{format, result.format} : result.words));
    nameFiles(names, has_format, result);
    result.format = inQt(line_drawing::commandOption(format)->valueIn(result.choices));
    result.options = line_drawing::sheetOptions(result.choices);
    if (result.is_collection) return result;
    QStringList mesh_names;
    for (const QString& mesh : result.meshes)
        mesh_names << readable(QFileInfo(mesh).completeBaseName());
    result.options.title = line_drawing::titleOf(result.options.title, inUtf8(mesh_names));
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
