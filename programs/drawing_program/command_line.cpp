// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include "mesh_reading.h"

using line_drawing::refuse;

namespace {

const char* const format_option = "--format";  // of a collection

std::string take(Words& rest) {
    std::string first = std::move(rest.front());
    rest.erase(rest.begin());
    return first;
}

std::string takeValue(Words& rest, const std::string& option) {
    if (rest.empty()) refuse(option + " needs a value; see --help.");
    return take(rest);
}

/// Consumes an option with its value. False for the name of a file.
bool takeOption(const std::string& word, Words& rest, Words& formats, CommandLine& result) {
    if (word == "-h" || word == "--help") {
        result.help = true;
    } else if (word == "--version") {
        result.version = true;
    } else if (word == "--like") {
        result.like = earlierDrawing(takeValue(rest, word));
        rest.insert(rest.begin(), result.like->options.begin(), result.like->options.end());
    } else if (line_drawing::commandOption(word)) {
        Words& words = word == format_option ? formats : result.words;
        words.push_back(word);
        words.push_back(takeValue(rest, word));
    } else if (word.substr(0, 2) == "--") {
        refuse("unknown option " + word + "; see --help.");
    } else {
        return false;
    }
    return true;
}

/// A folder of drawings exists, or is named like one.
void nameFiles(const Words& names, CommandLine& result) {
    if (names.size() < 2) refuse("name two files: the drawing and the mesh; see --help.");
    result.drawing = names[0];
    result.is_collection = line_drawing::endsWith(names[0], "/") || isFolder(names[0]);
    result.meshes = meshesOf({names.begin() + 1, names.end()});
}

}  // namespace

std::string CommandLine::format() const {
    return line_drawing::commandOption(format_option)->valueIn(choices);
}

CommandLine parseCommandLine(Words rest) {
    CommandLine result;
    Words names, formats;
    while (!rest.empty()) {
        const std::string word = take(rest);
        if (word == "--")
            names.insert(names.end(), rest.begin(), rest.end()), rest.clear();
        else if (!takeOption(word, rest, formats, result))
            names.push_back(word);
    }
    if (result.help || result.version) return result;
    const bool has_format = !formats.empty();
    formats.insert(formats.begin(), result.words.begin(), result.words.end());
    result.choices = line_drawing::readChoices(formats);
    nameFiles(names, result);
    if (has_format && !result.is_collection)
        refuse("--format is for a folder of drawings; the extension of a file sets its format.");
    result.choices.file = result.is_collection ? '.' + result.format() : result.drawing;
    result.options = line_drawing::sheetOptions(result.choices);
    return result;
}

std::string usage() {
    return "laplacian-lines FILE" + line_drawing::endingsInWords("|", "|") +
           " [OPTION...] MESH|FOLDER...\n"
           "                       a measured drawing of a mesh, or of several that hide each "
           "other\n"
           "laplacian-lines FOLDER/ [OPTION...] MESH|FOLDER...\n"
           "                       one of each, and a contact sheet\n"
           "\n" +
           line_drawing::sheetOptionsHelp() +
           "  --like FILE          with the options that a drawing (SVG, PDF, DXF) was made with;\n"
           "                       others that follow count more\n"
           "  --version            of this program\n"
           "  --help               this text\n";
}

void say(FILE* stream, const std::string& line) {
    std::fprintf(stream, "%s\n", line.c_str());
    std::fflush(stream);
}
