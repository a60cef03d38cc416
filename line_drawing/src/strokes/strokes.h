// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "line_drawing/sheet.h"
#include "views/drawn_view.h"

namespace line_drawing {

/// Removes specks, on the sheet: contours of curved surfaces before a jump in depth of less than a
/// pen, small sets of connected lines in which no way leads around, dots, and short ends in
/// nothing. Outlines stay.
std::vector<DrawnLine> without_specks(std::vector<DrawnLine> lines, const SheetOptions& options);

/// Joins ends, of at least two points, that have lost the line they met: by `left_out` short lines
/// that lead on to another, else by a straight piece; an edge that has passed another ends there.
/// Other ends stay, since lines may meet them. `reach`: of what doubles a line.
void join_edges(std::vector<DrawnLine>& lines, const std::vector<DrawnLine>& left_out,
                double reach);

/// Removes parts of lines that only double others, in the sheet's coordinates: of lower classes
/// along higher ones (sections first), in a class along longer ones; also jogs, and short lines
/// that are beside others nearly all along, unless they join an end to another line. What is left
/// meets the lines beside its ends.
std::vector<DrawnLine> without_doubles(std::vector<DrawnLine> lines, double reach);

/// Gives edges and contours that continue each other one class, that of the greater part of them: a
/// line of the form has one width. `reach`: as of doubles.
void even_out_classes(std::vector<DrawnLine>& lines, double reach);

/// Joins inner lines that continue each other into one stroke, where they meet or across gaps of up
/// to eight pens, half as long as either line, that no other line crosses, if all turns to one
/// side; and contours within the surface that meet. With `mixes_kinds`, contours of curved surfaces
/// are joined as inner lines are, whichever way they turn, also to these, blending their widths.
/// `pens`: widths in mm, by LineClass.
std::vector<DrawnLine> chain(std::vector<DrawnLine> lines, const Pens& pens, bool mixes_kinds);

/// Leaves white between lines, mm on the sheet: strongest first, an inner line goes where it runs
/// within three pens of another one, or within half a pen of an outline, contour or edge, but not
/// where lines cross or meet. So do strokes shorter than six pens, those within four pens of each
/// other, and loops below 24. Of edges side by side with less than half a pen between them, the
/// first and the last stay, and as many between as have that white.
/// `pens`: widths in mm, by LineClass.
std::vector<DrawnLine> thin_out(std::vector<DrawnLine> lines, const Pens& pens);

/// Cuts off bent ends of inner lines, where a zero of the Laplacian runs around the end of a
/// feature; an illustrator would not draw that. Up to six pens long, or a third of the line if they
/// are fainter than it. Ends that meet another line stay. `pen`: of inner lines, mm.
void cut_hooks(std::vector<DrawnLine>& lines, double pen);

/// Leaves out inner lines and contours of curved surfaces that are shorter than `shortest`, mm, or
/// rings of twice that, and meet no other line, but for inner lines with a like one beside them,
/// which are a texture; contours shorter than six pens that do not lead from one edge of the form
/// to another; and borders of holes that would be dots.
std::vector<DrawnLine> without_fragments(std::vector<DrawnLine> lines, double shortest, double pen);

/// Makes inner lines and contours of curved surfaces at least as wide as fine lines, and has them
/// end in a point where they meet no other line; inner lines swell over a third of their length.
/// `pens`: widths in mm, by LineClass.
void point_ends(std::vector<DrawnLine>& lines, const Pens& pens);

/// An end of an inner line that meets another line.
struct MetEnd {
    std::size_t line;
    bool is_last;
    std::size_t met;
};

/// Extends ends of inner lines that are drawn in full and head for another line to that line, over
/// at most three pens: edges of features meet each other and outlines. Returns these ends, and
/// those that met a line before.
std::vector<MetEnd> join_ends(std::vector<DrawnLine>& lines, double pen);

/// Moves ends with the line they met, if that has moved by less than a pen.
void follow_met(const std::vector<MetEnd>& ends, double pen, std::vector<DrawnLine>& lines);

/// Smooths the triangles' edges out of contours of curved surfaces: between exact points lines bend
/// as little as they can within `reach`, on the sheet, and lines that end at them follow.
/// Afterwards all points of contours count as smoothed.
void smooth_contours(std::vector<DrawnLine>& lines, double reach);

/// The same for inner lines as drawn; what continues them stays.
void smooth_inner_lines(std::vector<DrawnLine>& lines, double reach);

/// Appends cubic Bézier curves to `path`, after a move_to(), that pass within `tolerance` of all
/// points, with corners where the points turn sharply. A closed line repeats its first point. P. J.
/// Schneider, "An Algorithm for Automatically Fitting Digitized Curves", Graphics Gems (1990).
void fit_curve(const std::vector<Eigen::Vector2d>& points, bool closed, double tolerance,
               Path& path);

/// In the sheet's coordinates; none if the line is too short or too thin.
std::optional<SheetPath> draw_stroke(const DrawnLine& line, const SheetOptions& options);

}  // namespace line_drawing
