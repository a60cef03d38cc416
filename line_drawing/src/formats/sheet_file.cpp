// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include "formats/sheet_writers.h"
#include "laplacian_lines/version.h"
#include "planes/lettering.h"

namespace line_drawing {
namespace {

const char* const kProvenanceBegin = "{\"laplacian_lines\":";

/// "SVG or DXF": files whose readers have letters of their own.
std::string formats_of_any_letter() {
    Words names;
    for (const SheetFormat& format : kSheetFormats)
        if (format.has_any_letter) names.push_back(upper(format.ending));
    return joined(names, " or ");
}

/// A JSON string in ASCII, with UTF-16 escapes.
std::string quoted(const std::string& text) {
    constexpr std::string_view escaped = "\"\\\b\f\n\r\t", letters = "\"\\bfnrt";
    std::string json = "\"";
    for (const char32_t c : letters_of(text)) {
        const std::size_t escape = c < 127 ? escaped.find(char(c)) : escaped.npos;
        if (escape != escaped.npos)
            json += {'\\', letters[escape]};
        else if (c < ' ' || c >= 127 || c == '<' || c == '>' || c == '&')
            json += lower(in_hexadecimal(c, "\\u"));
        else
            json += char(c);
    }
    return json + '"';
}

/// A member of a JSON object.
std::string meshes_text(const std::vector<SourceMesh>& meshes) {
    Words list;
    for (const SourceMesh& mesh : meshes) {
        const std::string hash = mesh.sha256.empty() ? "" : ",\"sha256\":" + quoted(mesh.sha256);
        list.push_back("{\"name\":" + quoted(mesh.name) + hash + '}');
    }
    return "\"meshes\":[" + joined(list, ",") + ']';
}

}  // namespace

const std::array<SheetFormat, 4> kSheetFormats = {{{"svg", write_svg, true, true},
                                                   {"pdf", write_pdf, false, true},
                                                   {"dxf", write_dxf, true, false},
                                                   {"png", write_png, false, true}}};

std::string list_of_endings(const char* between, const char* last) {
    std::string words;
    for (const SheetFormat& format : kSheetFormats) {
        if (!words.empty()) words += &format == &kSheetFormats.back() ? last : between;
        words += std::string(".") + format.ending;
    }
    return words;
}

const SheetFormat& format_of(const std::string& file) {
    for (const SheetFormat& format : kSheetFormats)
        if (ends_with(lower(file), std::string(".") + format.ending)) return format;
    refuse("\"" + file + "\" does not end in " + list_of_endings(", ", " or ") +
           ", which say what kind of file to write.");
}

std::string write_sheet(const Sheet& sheet, const std::string& file, double dpi) {
    return format_of(file).write(sheet, dpi);
}

std::vector<std::string> check_texts(const SheetOptions& options, const std::string& file) {
    if (format_of(file).has_any_letter && options.text == TextStyle::Letters) return {};
    const std::string of_title = missing_letter(one_line(options.title)),
                      of_source = missing_letter(one_line(options.source));
    const auto complaint = [](const std::string& letter, const std::string& text) {
        return "Only " + formats_of_any_letter() + " files with letters can have the letter \"" +
               letter + "\" of " + text;
    };
    if (!of_title.empty())
        refuse(complaint(of_title, "the title") + ". Write an " + formats_of_any_letter() +
               " file, or take another title.");
    if (of_source.empty()) return {};
    return {complaint(of_source, '"' + one_line(options.source) + '"') +
            ": a box stands for each such letter."};
}

std::string provenance_text(const std::vector<SourceMesh>& meshes,
                            const std::optional<Words>& options) {
    std::string text =
        kProvenanceBegin + quoted(laplacian_lines::version()) + ',' + meshes_text(meshes);
    if (options) {
        Words words;
        for (const std::string& option : *options)
            words.push_back(quoted(option));
        text += ",\"options\":[" + joined(words, ",") + ']';
    }
    return text + '}';
}

std::string provenance_in(std::string bytes) {
    bytes.erase(0, bytes.find(kProvenanceBegin));
    constexpr std::string_view line_end = "\n999\n";  // where DXF continues a line
    for (std::size_t at = 0; (at = bytes.find(line_end, at)) != bytes.npos;)
        bytes.erase(at, line_end.size());
    return bytes;
}

bool is_of_other_meshes(const std::string& bytes, const std::vector<SourceMesh>& meshes) {
    const std::string made = provenance_in(bytes);
    return !made.empty() && made.find(meshes_text(meshes) + '}') == made.npos;
}

}  // namespace line_drawing
