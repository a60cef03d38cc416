// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "line_drawing/sheet.h"
#include "views/drawn_view.h"

namespace line_drawing {

// Lines are on the sheet, lengths in mm. `reach`: of doubles, lines nearer to each other than this.
// `pen`: the width of inner lines; `pens`: widths by LineClass.

/// Removes specks: contours of curved surfaces less than an inner pen in front of what is behind
/// them, small sets of connected lines without a loop, dots, and short ends that meet nothing.
/// Outlines stay. The kernel of the options is a length.
std::vector<DrawnLine> without_specks(std::vector<DrawnLine> lines, const SheetOptions& options);

/// Joins ends whose line was removed as a double to another line, by one of the short lines
/// `left_out` that leads there, else by a straight piece. Edges that have passed another line are
/// cut back to it. Other ends stay, since lines may meet them. Each line has two points or more.
void join_edges(std::vector<DrawnLine>& lines, const std::vector<DrawnLine>& left_out,
                double reach);

/// Removes parts of lines that only double others: of lower classes along higher ones (sections
/// first), in a class along longer ones; also jogs, and short lines that are beside others nearly
/// all along, unless they join an end to another line. What is left meets the lines beside its
/// ends.
std::vector<DrawnLine> without_doubles(std::vector<DrawnLine> lines, double reach);

/// Gives edges and contours that continue each other one class, that of the greater part of them: a
/// line of the form has one width.
void even_out_classes(std::vector<DrawnLine>& lines, double reach);

/// Joins inner lines that continue each other into one stroke, where they meet or across gaps of up
/// to eight pens and half of either line, that no other line crosses, if all turns to one side; and
/// contours within the surface that meet. With `mixes_kinds`, contours of curved surfaces are
/// joined as inner lines are, whichever way they turn, also to these, blending their widths.
std::vector<DrawnLine> chain(std::vector<DrawnLine> lines, const Pens& pens, bool mixes_kinds);

/// Leaves white between lines: strongest first, an inner line is dropped where its middle is within
/// three pens of that of another one, or less than half a pen is white beside an outline, contour
/// or edge, but not where lines cross or meet. So are strokes shorter than six pens, faint, within
/// a box of four pens or between even folds (is_between_folds()), and loops shorter than 24. Of
/// edges side by side with less than half a pen between them, the first and the last stay, and as
/// many between as have that white; contours of curved surfaces stay if half of them has it.
std::vector<DrawnLine> thin_out(std::vector<DrawnLine> lines, const Pens& pens);

/// Cuts off bent ends of inner lines, where a zero of the Laplacian runs around the end of a
/// feature; an illustrator would not draw that. Up to six pens long, or a third of the line if they
/// are fainter than it. Ends that meet another line stay.
void cut_hooks(std::vector<DrawnLine>& lines, double pen);

/// Leaves out borders of holes that would be dots, and inner lines and contours of curved surfaces
/// that are shorter than `shortest`, or rings of twice that, and meet no other line; inner lines
/// with a like one beside them, a texture, stay; contours below six pens only if they lead from one
/// line of the form to another.
std::vector<DrawnLine> without_fragments(std::vector<DrawnLine> lines, double shortest, double pen);

/// Makes inner lines and contours of curved surfaces at least as wide as fine lines, and has them
/// end in a point where they meet no other line; inner lines swell over a third of their length.
void point_ends(std::vector<DrawnLine>& lines, const Pens& pens);

/// An end of an inner line that meets another line: the numbers of both.
struct MetEnd {
    std::size_t line;
    bool is_last;
    std::size_t met;
};

/// Extends ends of inner lines that are not faint and head for another line to that line, over at
/// most three pens: edges of features meet each other and outlines. Returns these ends, and those
/// that met a line before.
std::vector<MetEnd> join_ends(std::vector<DrawnLine>& lines, double pen);

/// Moves ends with the line they met, if that has moved by less than a pen.
void follow_met(const std::vector<MetEnd>& ends, double pen, std::vector<DrawnLine>& lines);

/// Smooths the triangles' edges out of contours of curved surfaces: between exact points lines bend
/// as little as they can within `reach` of where they were, and lines that end at them follow.
/// Afterwards all points of outlines and contours count as smoothed.
void smooth_contours(std::vector<DrawnLine>& lines, double reach);

/// The same for the points of all lines that are neither exact nor smoothed yet.
void smooth_inner_lines(std::vector<DrawnLine>& lines, double reach);

/// Appends cubic Bézier curves to `path`, after a move_to(), that pass within `tolerance` of all
/// points, with corners where the points turn sharply. A closed line repeats its first point.
void fit_curve(const std::vector<Eigen::Vector2d>& points, bool closed, double tolerance,
               Path& path);

/// None of a line without length, nor of a hidden one that is too short for dashes.
std::optional<SheetPath> draw_stroke(const DrawnLine& line, const SheetOptions& options);

}  // namespace line_drawing
