// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Prints what the program runs on and was built by, and a Markdown table of all sections with a
/// title, a column a mesh. The file `json`, if one is named, takes an object of machine, compiler
/// and all figures. @throws std::runtime_error if it cannot be written
void print_report(const std::vector<MeshFigures>& meshes, const std::string& json);

}  // namespace benchmarks
