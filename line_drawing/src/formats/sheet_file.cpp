// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include <algorithm>

#include "formats/sheet_writers.h"
#include "laplacian_lines/version.h"
#include "planes/lettering.h"

namespace line_drawing {
namespace {

const char* const provenance_begin = "{\"laplacian_lines\":";

/// "SVG or DXF": files whose readers have letters of their own.
std::string formatsOfAnyLetter() {
    Words names;
    for (const SheetFormat& format : sheet_formats)
        if (format.has_any_letter) names.push_back(upper(format.ending));
    return joined(names, " or ");
}

std::string numberOf(char32_t unit) {
    return "\\u" + lower(inHexadecimal(unit));
}

/// JSON has numbers for all characters, of UTF-16.
std::string quoted(const std::string& text) {
    constexpr std::string_view escaped = "\"\\\b\f\n\r\t", letters = "\"\\bfnrt";
    std::string json = "\"";
    for (const char32_t c : lettersOf(text)) {
        const std::size_t escape = c < 127 ? escaped.find(char(c)) : escaped.npos;
        if (escape != escaped.npos)
            json += {'\\', letters[escape]};
        else if (c >= 0x10000)
            json += numberOf(0xd7c0 + (c >> 10)) + numberOf(0xdc00 + (c & 0x3ff));
        else if (c < ' ' || c >= 127 || c == '<' || c == '>' || c == '&')
            json += numberOf(c);
        else
            json += char(c);
    }
    return json + '"';
}

/// The members of an object but for its end.
std::string meshesText(const std::vector<SourceMesh>& meshes) {
    Words list;
    for (const SourceMesh& mesh : meshes) {
        const std::string hash = mesh.sha256.empty() ? "" : ",\"sha256\":" + quoted(mesh.sha256);
        list.push_back("{\"name\":" + quoted(mesh.name) + hash + '}');
    }
    return "\"meshes\":[" + joined(list, ",") + ']';
}

}  // namespace

const std::array<SheetFormat, 4> sheet_formats = {{{"svg", writeSvg, true, true},
                                                   {"pdf", writePdf, false, true},
                                                   {"dxf", writeDxf, true, false},
                                                   {"png", writePng, false, true}}};

std::string endingsInWords(const char* between, const char* last) {
    std::string words;
    for (const SheetFormat& format : sheet_formats) {
        if (!words.empty()) words += &format == &sheet_formats.back() ? last : between;
        words += std::string(".") + format.ending;
    }
    return words;
}

const SheetFormat& formatOf(const std::string& file) {
    for (const SheetFormat& format : sheet_formats)
        if (endsWith(lower(file), std::string(".") + format.ending)) return format;
    refuse("\"" + file + "\" does not end in " + endingsInWords(", ", " or ") +
           ", which say what kind of file to write.");
}

std::string writeSheet(const Sheet& sheet, const std::string& file, double dpi) {
    return formatOf(file).write(sheet, dpi);
}

std::vector<std::string> checkTexts(const SheetOptions& options, const std::string& file) {
    if (formatOf(file).has_any_letter && options.text == TextStyle::Letters) return {};
    const std::string of_title = lackingLetter(oneLine(options.title)),
                      of_source = lackingLetter(oneLine(options.source));
    const auto complaint = [](const std::string& letter, const std::string& text) {
        return "Only " + formatsOfAnyLetter() + " files with letters can have the letter \"" +
               letter + "\" of " + text;
    };
    if (!of_title.empty())
        refuse(complaint(of_title, "the title") + ". Write an " + formatsOfAnyLetter() +
               " file, or take another title.");
    if (of_source.empty()) return {};
    return {complaint(of_source, '"' + oneLine(options.source) + '"') +
            ": a box stands for each such letter."};
}

std::string provenanceText(const std::vector<SourceMesh>& meshes,
                           const std::optional<Words>& options) {
    std::string text =
        provenance_begin + quoted(laplacian_lines::version()) + ',' + meshesText(meshes);
    if (options) {
        Words words;
        for (const std::string& option : *options)
            words.push_back(quoted(option));
        text += ",\"options\":[" + joined(words, ",") + ']';
    }
    return text + '}';
}

std::string provenanceIn(std::string bytes) {
    bytes.erase(0, bytes.find(provenance_begin));
    constexpr std::string_view line_end = "\n999\n";  // where DXF continues a line
    for (std::size_t at = 0; (at = bytes.find(line_end, at)) != bytes.npos;)
        bytes.erase(at, line_end.size());
    return bytes;
}

bool isOfOthers(const std::string& bytes, const std::vector<SourceMesh>& meshes) {
    const std::string made = provenanceIn(bytes);
    return !made.empty() && made.find(meshesText(meshes) + '}') == made.npos;
}

}  // namespace line_drawing
