// SPDX-License-Identifier: GPL-3.0-or-later
// The array that lines are handed over to OpenGL in.
#include "line_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "made_up_lines.h"

namespace {

using Eigen::Vector3f;
using laplacian_lines::LineKind;
using laplacian_lines::LineSet;
using line_renderer::LineRadii;
using line_renderer::neighbour_only;
using line_renderer::nothing_here;
using line_renderer::ScreenTransform;
using line_renderer::StreamPoint;
using line_renderer::StreamSettings;

LineRadii equalRadii(float radius) {
    LineRadii radii;
    radii.full.fill(radius);
    return radii;
}

/// With all points.
std::vector<StreamPoint> streamOf(const LineSet& lines, const LineRadii& radii,
                                  const ScreenTransform* measured_on = nullptr) {
    StreamSettings settings;
    settings.radii = radii;
    settings.tolerance.distance = 0;
    settings.is_measured = measured_on;
    if (measured_on) settings.screen = *measured_on;
    std::vector<StreamPoint> stream = writtenStream(lines, settings);
    EXPECT_EQ(stream.size(), line_renderer::streamLength(lines));
    return stream;
}

void expectPlace(const StreamPoint& point, const Vector3f& place) {
    EXPECT_EQ(Vector3f(point.position[0], point.position[1], point.position[2]), place);
}

TEST(LineStream, PutsEachLineBetweenTwoMarks) {
    LineSet lines = oneLine({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}});
    addLine(lines, {{5, 1, 2}, {6, 1, 2}});
    const std::vector<StreamPoint> stream = streamOf(lines, equalRadii(2));
    ASSERT_EQ(stream.size(), 3u + 2 + 2 + 2);
    for (std::size_t mark : {0, 4, 5, 8})
        EXPECT_EQ(stream[mark].radius, nothing_here) << mark;
    for (std::size_t point : {1, 2, 3, 6, 7})
        EXPECT_EQ(stream[point].radius, 2) << point;
    expectPlace(stream[2], {1, 0, 0});
    expectPlace(stream[7], {6, 1, 2});
}

TEST(LineStream, JoinsTheEndsOfClosedLines) {
    LineSet lines;
    addLine(lines, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}, LineKind::Contour, true);
    const std::vector<StreamPoint> stream = streamOf(lines, equalRadii(2));
    ASSERT_EQ(stream.size(), 6u);
    EXPECT_EQ(stream.front().radius, neighbour_only);
    EXPECT_EQ(stream.back().radius, neighbour_only);
    expectPlace(stream.front(), {1, 1, 0});
    expectPlace(stream.back(), {1, 0, 0});
}

// Long sets are written in parts.
TEST(LineStream, OfManyLinesIsThatOfEachLineAndOutlinesComeLast) {
    LineSet lines;
    std::vector<StreamPoint> parts[2];
    for (int number = 0; number < 3000; ++number) {
        std::vector<Vector3f> points;
        for (int i = 0; i < number % 23; ++i)
            points.push_back({float(number), float(i), 0});
        const bool is_outline = number % 3 == 0;
        const LineKind kind = is_outline ? LineKind::Contour : LineKind::Laplacian;
        addLine(lines, points, kind);
        LineSet alone;
        addLine(alone, points, kind);
        const std::vector<StreamPoint> stream = streamOf(alone, equalRadii(2));
        parts[is_outline].insert(parts[is_outline].end(), stream.begin(), stream.end());
    }
    parts[0].insert(parts[0].end(), parts[1].begin(), parts[1].end());
    const std::vector<StreamPoint> stream = streamOf(lines, equalRadii(2));
    ASSERT_EQ(stream.size(), parts[0].size());
    EXPECT_EQ(std::memcmp(stream.data(), parts[0].data(), stream.size() * sizeof stream[0]), 0);
}

TEST(LineStream, LeavesOutLinesWithoutASegment) {
    LineSet lines = oneLine({{0, 0, 0}});
    addLine(lines, {});
    EXPECT_EQ(line_renderer::streamLength(lines), 0u);
    addLine(lines, {{0, 0, 0}, {1, 0, 0}});
    EXPECT_EQ(streamOf(lines, equalRadii(2)).size(), 4u);
}

TEST(LineStream, HasOutlinesLast) {
    LineSet lines;
    addLine(lines, {{0, 0, 0}, {1, 0, 0}}, LineKind::Contour);
    addLine(lines, {{0, 1, 0}, {1, 1, 0}}, LineKind::SuggestiveHighlight);
    addLine(lines, {{0, 2, 0}, {1, 2, 0}}, LineKind::Border);
    addLine(lines, {{0, 3, 0}, {1, 3, 0}}, LineKind::Ridge);
    const std::vector<StreamPoint> stream = streamOf(lines, equalRadii(2));
    ASSERT_EQ(stream.size(), 4u * 4);
    expectPlace(stream[1], {0, 1, 0});
    expectPlace(stream[5], {0, 3, 0});
    expectPlace(stream[9], {0, 0, 0});
    expectPlace(stream[13], {0, 2, 0});
}

TEST(LineStream, HasTheNumberOfTheKindAsLook) {
    for (std::size_t kind = 0; kind < laplacian_lines::line_kind_count; ++kind) {
        LineSet lines;
        addLine(lines, {{0, 0, 0}, {1, 0, 0}}, LineKind(kind));
        LineRadii radii = equalRadii(1);
        radii.full[kind] = 2;
        const std::vector<StreamPoint> stream = streamOf(lines, radii);
        ASSERT_EQ(stream.size(), 4u);
        for (const StreamPoint& point : stream)
            EXPECT_EQ(std::floor(point.look), float(kind));
        EXPECT_EQ(stream[1].radius, 2) << kind;
    }
}

TEST(LineStream, MarksBordersAndCreasesAndWhichFaceAway) {
    LineSet lines;
    for (const LineKind kind : {LineKind::Border, LineKind::Crease, LineKind::Crease})
        addLine(lines, {{0, 0, 0}, {1, 0, 0}}, kind);
    lines.lines.back().slope = -1;
    const std::vector<StreamPoint> stream = streamOf(lines, equalRadii(1));
    ASSERT_EQ(stream.size(), 12u) << "the border last";
    EXPECT_EQ(stream[1].look, float(LineKind::Crease) + line_renderer::edge_mark);
    EXPECT_EQ(stream[5].look, float(LineKind::Crease) + line_renderer::away_mark);
    EXPECT_EQ(stream[9].look, float(LineKind::Border) + line_renderer::edge_mark);
}

/// Where both ends are vertices; such a piece never replaces its neighbours.
TEST(LineStream, MarksWhatFollowsEdges) {
    LineSet lines;
    for (const LineKind kind : {LineKind::Contour, LineKind::Laplacian}) {
        addLine(lines, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, kind);
        putOnVertices(lines, lines.points.size() - 4, 3);
    }
    StreamSettings settings;
    settings.radii = equalRadii(2);
    settings.tolerance.depth.fill(1);
    const std::vector<StreamPoint> stream = writtenStream(lines, settings);
    ASSERT_EQ(stream.size(), 4u + 6) << "the Laplacian line first, of one piece";
    for (const std::size_t point : {1, 2})
        EXPECT_EQ(stream[point].look, float(LineKind::Laplacian));
    const float contour = float(LineKind::Contour);
    EXPECT_EQ(stream[5].look, contour);
    EXPECT_EQ(stream[6].look, contour + line_renderer::edge_mark);
    EXPECT_EQ(stream[7].look, contour);
    expectPlace(stream[6], {1, 0, 0});
    expectPlace(stream[7], {3, 0, 0});
}

TEST(LineStream, TapersWithTheWeight) {
    LineSet lines = oneLine({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    lines.points[0].weight = 0;
    lines.points[1].weight = 0.5f;
    lines.points[3].weight = 7;  // counts as 1
    lines.points[2].opacity = 0.25f;
    LineRadii radii = equalRadii(4);
    radii.least_share = 0.5f;
    const std::vector<StreamPoint> stream = streamOf(lines, radii);
    EXPECT_FLOAT_EQ(stream[1].radius, 2);
    EXPECT_FLOAT_EQ(stream[2].radius, 3);
    EXPECT_FLOAT_EQ(stream[4].radius, 4);
    EXPECT_EQ(stream[3].opacity, 0.25f);
}

/// 200 pixels across and 100 up for two units of clip coordinates, halved.
ScreenTransform screen() {
    ScreenTransform result;
    result.half_viewport = {100, 50};
    return result;
}

TEST(LineStream, MeasuresLinesOnTheScreen) {
    LineSet lines = oneLine({{0, 0, 0}, {0.5f, 0, 0}, {0.5f, 0.5f, 0.9f}});
    addLine(lines, {{0, 0, 0}, {0.03f, 0.08f, 0}});
    const ScreenTransform transform = screen();
    const std::vector<StreamPoint> stream = streamOf(lines, equalRadii(1), &transform);
    EXPECT_FLOAT_EQ(stream[1].along, 0);
    EXPECT_FLOAT_EQ(stream[2].along, 50);
    EXPECT_FLOAT_EQ(stream[3].along, 75);
    EXPECT_FLOAT_EQ(stream[6].along, 0) << "each line begins anew";
    EXPECT_FLOAT_EQ(stream[7].along, 5);
}

TEST(LineStream, MeasuresNothingUnlessAsked) {
    for (const StreamPoint& point : streamOf(oneLine({{0, 0, 0}, {0.5f, 0, 0}}), equalRadii(1)))
        EXPECT_EQ(point.along, 0);
}

TEST(LineStream, HasNoLengthBehindTheEye) {
    ScreenTransform transform = screen();
    transform.to_clip.row(3) << 0, 0, 1, 0;  // w = z
    const LineSet lines =
        oneLine({{0, 0, 1}, {0.5f, 0, 1}, {0.5f, 0, -1}, {0, 0, 1}, {0.1f, 0, 1}});
    const std::vector<StreamPoint> stream = streamOf(lines, equalRadii(1), &transform);
    EXPECT_FLOAT_EQ(stream[2].along, 50);
    EXPECT_FLOAT_EQ(stream[3].along, 50);
    EXPECT_FLOAT_EQ(stream[4].along, 50);
    EXPECT_FLOAT_EQ(stream[5].along, 60);
}

}  // namespace
