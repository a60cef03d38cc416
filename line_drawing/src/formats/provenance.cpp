// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/sheet_file.h"

#include "laplacian_lines/version.h"

namespace line_drawing {
namespace {

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

}  // namespace

std::string provenanceText(const std::vector<SourceMesh>& meshes,
                           const std::optional<Words>& options) {
    Words list, words;
    for (const SourceMesh& mesh : meshes) {
        const std::string hash = mesh.sha256.empty() ? "" : ",\"sha256\":" + quoted(mesh.sha256);
        list.push_back("{\"name\":" + quoted(mesh.name) + hash + '}');
    }
    std::string text = provenance_begin + quoted(laplacian_lines::version()) + ",\"meshes\":[" +
                       joined(list, ",") + ']';
    if (options) {
        for (const std::string& option : *options)
            words.push_back(quoted(option));
        text += ",\"options\":[" + joined(words, ",") + ']';
    }
    return text + '}';
}

}  // namespace line_drawing
