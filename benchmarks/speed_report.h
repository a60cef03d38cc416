// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace benchmarks {

/// A part of the report; in the table if it has a title.
struct Section {
    const char *key, *title;
};

/// A number of one mesh.
struct Figure {
    Section section;
    std::string key, text;  ///< names for programs and for people
    double value;
};

/// A column of the report.
struct MeshFigures {
    std::string name;
    std::vector<Figure> figures = {};

    /// At the end of its section.
    void add(const Section& section, const std::string& key, const std::string& text, double value);
    /// 0 if there is no such figure.
    double value(const Section& section, const std::string& key) const;
};

/// A Markdown table of all sections with a title, a column a mesh.
std::string markdown_table(const std::vector<MeshFigures>& meshes);
/// A JSON object of machine, compiler and all figures.
std::string json_report(const std::vector<MeshFigures>& meshes);

/// What the program runs on and was built by, in one line.
std::string machine_text();

}  // namespace benchmarks
