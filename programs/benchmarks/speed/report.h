// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace benchmarks {

/// In the table if it has a title.
struct Section {
    const char *key, *title;
};

struct Figure {
    Section section;
    std::string key, text;  ///< names for programs and for people
    double value;
};

struct MeshFigures {
    std::string name;
    std::vector<Figure> figures = {};

    void add(const Section& section, const std::string& key, const std::string& text, double value);
    double value(const Section& section, const std::string& key) const;
};

/// Prints machine and compiler and a Markdown table of all titled sections, a column per mesh. The
/// file `json`, if named, gets all of it. @throws std::runtime_error if it cannot be written
void print_report(const std::vector<MeshFigures>& meshes, const std::string& json);

}  // namespace benchmarks
