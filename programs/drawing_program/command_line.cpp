// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <algorithm>
#include <filesystem>

#include "json.h"
#include "laplacian_lines/version.h"
#include "mesh_reading.h"

using line_drawing::refuse;
using line_drawing::SourceMesh;

namespace {

const char* const kFormatOption = "--format";  // of a collection

/// The JSON object at the start of the file's line of provenance.
Json provenance_of(const std::string& name) {
    const std::optional<std::string> read = contents_of(name);
    if (!read) refuse("\"" + name + "\" cannot be read.");
    const std::optional<Json> object = json_in(line_drawing::provenance_in(*read));
    if (!object || object->members.empty())
        refuse(
            "\"" + name +
            "\" does not say how it was drawn: drawings of version 0.3 do, and all of later ones.");
    return *object;
}

/// Files come from anywhere: they must not name other files.
bool is_option(const std::string& word) {
    return word.substr(0, 2) == "--" && word != "--" && word != "--like" &&
           word.find('=') == std::string::npos;
}

/// Reads the provenance of a file that is to be drawn again.
/// @throws laplacian_lines::Error(InvalidOption) if the file has none.
EarlierDrawing earlier_drawing(const std::string& file) {
    Json object = provenance_of(file);
    const bool has_options = object.members.count("options") != 0;
    EarlierDrawing earlier{object.members["laplacian_lines"].text, {}, {}};
    for (Json& mesh : object.members["meshes"].items)
        earlier.meshes.push_back({mesh.members["name"].text, mesh.members["sha256"].text});
    for (const Json& word : object.members["options"].items)  // version 0.3.0 said --furniture
        earlier.options.push_back(word.text == "--furniture" ? "--annotations" : word.text);
    bool are_pairs = has_options && earlier.options.size() % 2 == 0;
    for (std::size_t i = 0; are_pairs && i < earlier.options.size(); i += 2)
        are_pairs = is_option(earlier.options[i]);
    if (!are_pairs)
        refuse("\"" + file + "\" has no options of this command: it was drawn in another way.");
    return earlier;
}

std::string take(Words& rest) {
    std::string first = std::move(rest.front());
    rest.erase(rest.begin());
    return first;
}

std::string take_value(Words& rest, const std::string& option) {
    if (rest.empty()) refuse(option + " needs a value; see --help.");
    return take(rest);
}

/// Puts "--option", "value" in place of a first "--option=value".
void split_assignment(Words& rest) {
    const std::size_t equals = rest.front().find('=');
    if (rest.front().substr(0, 2) != "--" || equals == std::string::npos) return;
    const std::string value = rest.front().substr(equals + 1);
    rest.front().resize(equals);
    rest.insert(rest.begin() + 1, value);
}

/// Consumes an option with its value. False for the name of a file.
bool take_option(const std::string& word, Words& rest, Words& formats, CommandLine& result) {
    if (word == "-h" || word == "--help") {
        result.help = true;
    } else if (word == "--version") {
        result.version = true;
    } else if (word == "--like") {
        result.like = earlier_drawing(take_value(rest, word));
        rest.insert(rest.begin(), result.like->options.begin(), result.like->options.end());
    } else if (line_drawing::command_option(word)) {
        Words& words = word == kFormatOption ? formats : result.words;
        words.push_back(word);
        words.push_back(take_value(rest, word));
    } else if (word.substr(0, 2) == "--") {
        refuse("unknown option " + word + "; see --help.");
    } else {
        return false;
    }
    return true;
}

/// The drawing is a folder if there is a folder of this name, or if the name ends in a slash.
void name_files(const Words& names, CommandLine& result) {
    if (names.size() < 2) refuse("name the drawing first, then the mesh; see --help.");
    if (is_named_like_mesh(names[0]))
        refuse("\"" + names[0] + "\" is a mesh: name the drawing first, as in laplacian-lines " +
               "drawing.svg " + names[0]);
    result.drawing = names[0];
    const bool has_name = names[0].empty() || std::filesystem::u8path(names[0]).has_filename();
    result.is_collection = !has_name || is_folder(names[0]);
    result.meshes = meshes_of({names.begin() + 1, names.end()});
}

}  // namespace

CommandLine parse_command_line(Words rest) {
    CommandLine result;
    Words names, formats;
    while (!rest.empty()) {
        split_assignment(rest);
        const std::string word = take(rest);
        if (word == "--") {
            names.insert(names.end(), rest.begin(), rest.end());
            rest.clear();
        } else if (!take_option(word, rest, formats, result)) {
            names.push_back(word);
        }
    }
    if (result.help || result.version) return result;
    const bool has_format = !formats.empty();
    formats.insert(formats.begin(), result.words.begin(), result.words.end());
    result.choices = line_drawing::read_choices(formats);
    name_files(names, result);
    if (has_format && !result.is_collection)
        refuse("--format is for a folder of drawings; the extension of a file sets its format.");
    result.choices.file =
        result.is_collection
            ? '.' + line_drawing::command_option(kFormatOption)->value_in(result.choices)
            : result.drawing;
    result.options = line_drawing::sheet_options(result.choices);
    return result;
}

std::string usage() {
    return "laplacian-lines FILE" + line_drawing::list_of_endings("|", "|") +
           " [OPTION...] MESH|FOLDER...\n"
           "                       a measured drawing of a mesh, or of several that hide each "
           "other\n"
           "laplacian-lines FOLDER/ [OPTION...] MESH|FOLDER...\n"
           "                       one of each, and a contact sheet\n"
           "\n" +
           line_drawing::sheet_options_help() +
           "  --like FILE          with the options that a drawing was made with;\n"
           "                       others that follow count more\n"
           "  --version            of this program\n"
           "  --help               this text\n";
}

void say_what_differs(const EarlierDrawing& earlier, const std::vector<SourceMesh>& meshes) {
    if (earlier.version != laplacian_lines::version())
        say(stderr, "the file was drawn by version " + earlier.version + "; this is version " +
                        laplacian_lines::version());
    if (earlier.meshes.size() != meshes.size())
        say(stderr, "the file was drawn from " + std::to_string(earlier.meshes.size()) +
                        " meshes; now there are " + std::to_string(meshes.size()));
    for (const SourceMesh& mesh : meshes)
        if (std::none_of(earlier.meshes.begin(), earlier.meshes.end(),
                         [&](const SourceMesh& m) { return m.sha256 == mesh.sha256; }))
            say(stderr,
                mesh.name + " is not the mesh that the file was drawn from: its contents differ");
}

void say(FILE* stream, const std::string& line) {
    std::fprintf(stream, "%s\n", line.c_str());
    std::fflush(stream);
}
