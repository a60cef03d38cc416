// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/line_parts.h"

#include <algorithm>
#include <cmath>

namespace laplacian_lines {
namespace {

std::uint32_t segment_count(const Polyline& line) {
    return line.count > 0 ? line.count - 1 : 0;
}

double segment_length(const LineSet& lines, const Polyline& line, std::uint32_t segment) {
    const LinePoint* points = lines.points.data() + line.first;
    return double((points[segment + 1].position - points[segment].position).norm());
}

}  // namespace

LinePoint point_at(const LineSet& lines, const Polyline& line, const LinePlace& place) {
    const LinePoint& a = lines.points[line.first + place.segment];
    const LinePoint& b = lines.points[line.first + place.segment + 1];
    const float t = float(place.t);
    return {a.position + t * (b.position - a.position), a.weight + t * (b.weight - a.weight),
            a.gradient + t * (b.gradient - a.gradient), a.opacity + t * (b.opacity - a.opacity)};
}

std::vector<LinePiece> pieces_of(const LineSet& lines, const Polyline& line, double spacing,
                                 const std::vector<LinePlace>& places) {
    std::vector<LinePiece> pieces;
    LinePiece piece{{0, 0}, {0, 0}, 0};
    const auto end_piece = [&](const LinePlace& next, int number) {
        if (piece.length > 0) pieces.push_back(piece);
        piece = {next, next, 0, piece.length > 0 || number >= 0 ? number : piece.place};
    };
    std::size_t next = 0;
    for (std::uint32_t segment = 0; segment < segment_count(line); ++segment) {
        const double length = segment_length(lines, line, segment);
        const auto go_to = [&](double t) {
            while (piece.length + (t - piece.end.t) * length > spacing) {
                const double rest = spacing - piece.length;
                piece.end.t = std::min(t, piece.end.t + rest / length);
                piece.length = spacing;
                end_piece(piece.end, -1);
            }
            piece.length += (t - piece.end.t) * length;
            piece.end.t = t;
        };
        piece.end = {segment, 0};
        if (piece.length == 0) piece.begin = piece.end;
        for (; next < places.size() && places[next].segment == segment; ++next) {
            go_to(places[next].t);
            end_piece(places[next], int(next));
        }
        go_to(1);
    }
    end_piece({}, -1);
    return pieces;
}

LinePlace middle_of(const LineSet& lines, const Polyline& line, const LinePiece& piece) {
    double rest = piece.length / 2;
    for (std::uint32_t segment = piece.begin.segment; segment <= piece.end.segment; ++segment) {
        const double begin = segment == piece.begin.segment ? piece.begin.t : 0;
        const double end = segment == piece.end.segment ? piece.end.t : 1;
        const double length = segment_length(lines, line, segment);
        if (rest <= (end - begin) * length) return {segment, begin + rest / length};
        rest -= (end - begin) * length;
    }
    return piece.end;
}

std::vector<LinePart> parts_of(const Polyline& line, const std::vector<LinePiece>& pieces,
                               const std::vector<std::uint8_t>& labels, std::uint8_t label,
                               const std::function<LinePlace(std::size_t piece)>& begin_of) {
    const std::size_t n = pieces.size();
    std::vector<LinePart> parts;
    const auto count = std::size_t(std::count(labels.begin(), labels.end(), label));
    if (count == 0) return parts;
    if (count == n) {
        parts.push_back({pieces[0].begin, pieces[n - 1].end, true});
        return parts;
    }
    const auto changes = [&](std::size_t i) {
        return i == 0 ? line.closed && labels[0] != labels[n - 1] : labels[i] != labels[i - 1];
    };
    std::size_t first = 0;  // of a closed line, where its parts begin
    while (line.closed && !changes(first))
        ++first;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = (first + k) % n;
        if (changes(i) && k > 0 && labels[i] != label) parts.back().end = begin_of(i);
        if (labels[i] != label) continue;
        if (changes(i) || k == 0) parts.push_back({changes(i) ? begin_of(i) : pieces[i].begin, {}});
        parts.back().end = pieces[i].end;
    }
    if (line.closed && labels[(first + n - 1) % n] == label) parts.back().end = begin_of(first);
    return parts;
}

void append_part(const LineSet& from, const Polyline& line, const LinePart& part, double diagonal,
                 LineSet& to) {
    Polyline result = line;
    result.first = std::uint32_t(to.points.size());
    if (part.whole) {
        const auto first = from.points.begin() + line.first;
        to.points.insert(to.points.end(), first, first + line.count);
        to.lines.push_back(result);
        return;
    }
    const std::uint32_t segments = segment_count(line);
    to.points.push_back(point_at(from, line, part.begin));
    const bool runs_over = part.end.segment < part.begin.segment ||
                           (part.end.segment == part.begin.segment && part.end.t < part.begin.t);
    const std::uint32_t between =
        part.end.segment + (runs_over ? segments : 0) - part.begin.segment;
    for (std::uint32_t i = 1; i <= between; ++i)
        to.points.push_back(from.points[line.first + (part.begin.segment + i) % segments]);
    to.points.push_back(point_at(from, line, part.end));
    result.closed = false;
    result.count = std::uint32_t(to.points.size()) - result.first;
    result.length = 0;
    for (std::uint32_t segment = 0; segment + 1 < result.count; ++segment)
        result.length += float(segment_length(to, result, segment) / diagonal);
    to.lines.push_back(result);
}

}  // namespace laplacian_lines
