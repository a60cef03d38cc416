// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include <thread>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "program.h"

namespace benchmarks {
namespace {

/// Three digits, or a whole integer, in groups of three.
std::string number(double value) {
    char text[40];
    const double size = std::abs(value);
    const int decimals = size >= 100 || value == std::floor(value) ? 0
                         : size >= 10                              ? 1
                         : size >= 1                               ? 2
                         : size >= 0.1                             ? 3
                                                                   : 4;
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    std::string result = text;
    if (decimals == 0)
        for (int i = int(result.size()) - 3; i > int(value < 0); i -= 3)
            result.insert(std::size_t(i), ",");
    return result;
}

bool same(const Figure& a, const Figure& b) {
    return !std::strcmp(a.section.key, b.section.key) && a.key == b.key;
}

/// One figure for each row of any mesh; rows that only some have stay in place.
std::vector<Figure> rows_of(const std::vector<MeshFigures>& meshes) {
    std::vector<Figure> rows;
    for (const MeshFigures& mesh : meshes) {
        auto place = rows.begin();
        for (const Figure& f : mesh.figures) {
            const auto found = std::find_if(rows.begin(), rows.end(),
                                            [&](const Figure& row) { return same(row, f); });
            place = found == rows.end() ? rows.insert(place, f) : found;
            ++place;
        }
    }
    return rows;
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        if (static_cast<unsigned char>(c) >= ' ') result += c;
    }
    return result + '"';
}

std::string json_number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", value);
    return std::isfinite(value) ? text : "null";
}

std::string json_of(const MeshFigures& mesh) {
    std::string text = "{\"name\": " + quoted(mesh.name);
    const char* section = "";
    for (const Figure& f : mesh.figures) {
        if (!std::strcmp(section, f.section.key)) {
            text += ", ";
        } else {
            text += std::string(*section ? "}" : "") + ",\n   " + quoted(f.section.key) + ": {";
            section = f.section.key;
        }
        text += quoted(f.key) + ": " + json_number(f.value);
    }
    return text + (*section ? "}}" : "}");
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.rfind("model name", 0) == 0 && line.find(": ") != line.npos)
            return line.substr(line.find(": ") + 2);
    return "unknown processor";
}

const char* compiler() {
#if defined(__clang__)
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

std::string markdown_table(const std::vector<MeshFigures>& meshes) {
    std::string text = "| |";
    for (const MeshFigures& mesh : meshes)
        text += " " + mesh.name + " |";
    text += "\n|---|";
    for (std::size_t i = 0; i < meshes.size(); ++i)
        text += "--:|";
    const char* section = "";
    for (const Figure& row : rows_of(meshes)) {
        if (!row.section.title) continue;
        if (std::strcmp(section, row.section.key)) {
            section = row.section.key;
            text += std::string("\n| **") + row.section.title + "** |";
            for (std::size_t i = 0; i < meshes.size(); ++i)
                text += " |";
        }
        text += "\n| " + row.text + " |";
        for (const MeshFigures& mesh : meshes) {
            const auto f = std::find_if(mesh.figures.begin(), mesh.figures.end(),
                                        [&](const Figure& g) { return same(g, row); });
            text += " " + (f == mesh.figures.end() ? "–" : number(f->value)) + " |";
        }
    }
    return text + "\n";
}

std::string json_report(const std::vector<MeshFigures>& meshes) {
    std::string text =
        "{\"machine\": {\"processor\": " + quoted(processor()) +
        ", \"processors\": " + std::to_string(int(std::thread::hardware_concurrency())) +
        "},\n \"compiler\": " + quoted(compiler()) + ",\n \"meshes\": [";
    for (const MeshFigures& mesh : meshes)
        text += (&mesh == meshes.data() ? "\n  " : ",\n  ") + json_of(mesh);
    return text + "\n ]}\n";
}

}  // namespace

void MeshFigures::add(const Section& section, const std::string& key, const std::string& text,
                      double value) {
    const auto last = std::find_if(figures.rbegin(), figures.rend(), [&](const Figure& f) {
        return !std::strcmp(f.section.key, section.key);
    });
    figures.insert(last == figures.rend() ? figures.end() : last.base(),
                   {section, key, text, value});
}

double MeshFigures::value(const Section& section, const std::string& key) const {
    for (const Figure& f : figures)
        if (same(f, {section, key, {}, 0})) return f.value;
    return 0;
}

void print_report(const std::vector<MeshFigures>& meshes, const std::string& json) {
    std::printf("%s, %d processors; %s\n\n%s", processor().c_str(),
                int(std::thread::hardware_concurrency()), compiler(),
                markdown_table(meshes).c_str());
    if (!json.empty()) write_file(json, json_report(meshes));
}

}  // namespace benchmarks
