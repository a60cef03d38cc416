// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "line_drawing/path.h"

namespace line_drawing {

// A sheet of paper in millimetres, x right and y down from its upper left corner. Plain data, all
// that a file format needs.

/// A stroke of even width, or, if that is 0, an area filled by the path's fill rule.
struct SheetPath {
    Path path;
    double pen_width = 0;
    double dash = 0;  ///< length of dashes, with gaps of half of it; 0: unbroken
    double tone = 0;  ///< of areas: 0 black, 1 white
};

enum class TextAnchor { Left, Middle, Right };  // in the order of their share of the width

struct SheetText {
    Eigen::Vector2d position;  ///< on the base line, at `anchor` of the text
    double height = 0;  ///< of the font: letters without accents and descenders have about 0.7
    TextAnchor anchor = TextAnchor::Left;
    std::string text;

    /// The left end of the text if it is this wide.
    Eigen::Vector2d begin(double width) const {
        return position - Eigen::Vector2d(width * int(anchor) / 2, 0);
    }
};

/// One class of lines: a layer of DXF and SVG.
struct SheetLayer {
    std::string key;   ///< of the class: "outline"; the same in all groups
    std::string name;  ///< for people
    std::vector<SheetPath> paths;
    std::vector<SheetText> texts;
};

/// A view with its lines, or the annotations of the sheet.
struct SheetGroup {
    std::string key;  ///< unique: "front"; of the annotations "sheet"
    std::string name;
    std::vector<SheetLayer> layers;
};

/// Calls mark(path or text, its group, its layer) in the order in which they are drawn.
template <class Mark>
void for_each_mark(const std::vector<SheetGroup>& groups, const Mark& mark) {
    for (const SheetGroup& group : groups)
        for (const SheetLayer& layer : group.layers) {
            for (const SheetPath& path : layer.paths)
                mark(path, group, layer);
            for (const SheetText& text : layer.texts)
                mark(text, group, layer);
        }
}

struct Sheet {
    Eigen::Vector2d size;  ///< width, height
    std::string title;
    std::vector<SheetGroup> groups;
    double scale = 1;  ///< drawn length over true length; 0: all views are in perspective
    /// √h of the inner lines in mm of the sheet; 0: there are none, or the mesh is too coarse for
    /// any.
    double kernel = 0;
    std::string provenance = {};  ///< metadata of files, as provenance_text() has it; empty: none
    std::vector<std::string> remarks = {};  ///< messages for the user
};

}  // namespace line_drawing
