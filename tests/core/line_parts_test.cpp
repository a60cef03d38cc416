// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/line_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "generators.h"
#include "helpers.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "mesh_noise.h"

using namespace laplacian_lines;

namespace {

constexpr float kKernel = 0.01f;

LineRules whole_rules() {
    LineRules rules;
    rules.whole = rules.use_slope = rules.concave_only = true;
    rules.kernel_size = kKernel;
    rules.least_gradient = 0.8f;
    rules.segment_slope = 0.004f;
    rules.line_slope = 0.012f;
    rules.fading = 1;
    rules.least_concavity = -0.5f;  // tested before
    return rules;
}

constexpr float kStep = 0.1f * kKernel;

/// Pieces of equal length, clear unless changed.
struct MadeLine {
    std::vector<float> slope, gradient, concavity;
    bool closed = false;

    explicit MadeLine(std::size_t count)
        : slope(count, 0.1f), gradient(count, 4), concavity(count, 1) {}
    std::vector<LinePiece> pieces() const {
        std::vector<LinePiece> pieces;
        for (std::size_t i = 0; i < slope.size(); ++i)
            pieces.push_back(
                {kStep, kStep * slope[i], kStep * gradient[i], kStep * gradient[i] * concavity[i]});
        return pieces;
    }
};

MadeLine open_line(std::size_t pieces) {
    return MadeLine(pieces);
}

MadeLine ring(std::size_t pieces) {
    MadeLine line(pieces);
    line.closed = true;
    return line;
}

LinePartFinder found_in(const MadeLine& line, const LineRules& rules = whole_rules()) {
    LinePartFinder finder;
    finder.find(rules, line.pieces(), line.closed);
    return finder;
}

TEST(LineParts, AClearLineIsDrawnWhole) {
    for (MadeLine line : {open_line(300), ring(300)}) {
        const LinePartFinder finder = found_in(line);
        ASSERT_EQ(finder.parts().size(), 1u);
        EXPECT_EQ(finder.parts()[0].count, 300u);
        EXPECT_EQ(finder.parts()[0].closed, line.closed);
        for (std::size_t i = 0; i <= 300; ++i)
            EXPECT_FLOAT_EQ(finder.opacity(i), 1);
    }
}

TEST(LineParts, SlopesAreMeansAlongTheLine) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> slopes(-0.1f, 0.2f);
    for (MadeLine line : {open_line(200), ring(200)}) {
        for (float& slope : line.slope)
            slope = slopes(random);
        const LinePartFinder finder = found_in(line);
        const auto segments = std::ptrdiff_t(line.slope.size());
        for (std::ptrdiff_t i = 0; i <= segments; ++i) {
            double sum = 0, length = 0;  // of tenths of pieces within 15 of them
            for (std::ptrdiff_t k = -150; k < 150; ++k) {
                std::ptrdiff_t segment = i + std::ptrdiff_t(std::floor((double(k) + 0.5) / 10));
                if (line.closed) segment = (segment + 2 * segments) % segments;
                if (segment < 0 || segment >= segments) continue;
                sum += double(line.slope[std::size_t(segment)]);
                length += 1;
            }
            EXPECT_NEAR(finder.slope(std::size_t(i)), sum / length, 2e-4) << i << line.closed;
        }
    }
}

TEST(LineParts, TextureDoesNotCutALineThatIsClearOnTheWhole) {
    MadeLine line = open_line(400);
    for (std::size_t i = 0; i < 400; ++i) {  // every third segment is a convex phantom
        line.slope[i] = i % 3 ? 0.1f : -0.06f;
        line.concavity[i] = i % 3 ? 1.f : -0.5f;
    }
    const LinePartFinder finder = found_in(line);
    ASSERT_EQ(finder.parts().size(), 1u);
    EXPECT_EQ(finder.parts()[0].count, 400u);
}

TEST(LineParts, PhantomsConvexAndFlatPlacesAreNotDrawn) {
    MadeLine phantom = open_line(200), convex = open_line(200), flat = open_line(200);
    std::fill(phantom.slope.begin(), phantom.slope.end(), -0.1f);
    std::fill(convex.concavity.begin(), convex.concavity.end(), -0.9f);
    std::fill(flat.gradient.begin(), flat.gradient.end(), 0.1f);
    EXPECT_TRUE(found_in(phantom).parts().empty());
    EXPECT_TRUE(found_in(convex).parts().empty());
    EXPECT_TRUE(found_in(flat).parts().empty());
    LineRules both_sides = whole_rules();
    both_sides.concave_only = false;
    EXPECT_EQ(found_in(convex, both_sides).parts().size(), 1u);
}

/// Joining another line as the view turns changes it near the joint only.
TEST(LineParts, DoNotDependOnWhatIsSomeKernelsAway) {
    MadeLine alone = open_line(400), joined = open_line(400);
    for (std::size_t i = 0; i < 400; ++i)
        alone.slope[i] = joined.slope[i] = i % 3 ? 0.01f : -0.002f;
    std::fill(joined.concavity.begin() + 200, joined.concavity.end(), -0.9f);
    const LinePartFinder before = found_in(alone), after = found_in(joined);
    for (std::size_t i = 0; i <= 185; ++i)
        EXPECT_FLOAT_EQ(before.opacity(i), after.opacity(i)) << i;
    EXPECT_GT(after.opacity(185), 0);
    EXPECT_EQ(after.opacity(215), 0);
}

TEST(LineParts, OfARingMayGoOnAcrossItsBeginning) {
    MadeLine line = ring(400);
    std::fill(line.slope.begin() + 150, line.slope.begin() + 250, -1.f);
    const LinePartFinder finder = found_in(line);
    ASSERT_EQ(finder.parts().size(), 1u);
    const LinePart& part = finder.parts()[0];
    EXPECT_FALSE(part.closed);
    EXPECT_GT(part.begin, 200u);
    EXPECT_GT(part.begin + part.count, 400u);  // past its beginning
    EXPECT_LT(part.begin + part.count, 400u + 200u);
}

/// Even changes fade a line evenly.
TEST(LineParts, ComeAndGoEvenly) {
    std::vector<float> before;
    for (int step = 0; step <= 400; ++step) {
        MadeLine line = open_line(300);
        for (std::size_t i = 0; i < 300; ++i) {
            line.slope[i] = i < 120 ? 0.1f : 0.02f - 0.0001f * float(step);
            line.concavity[i] = i < 200 ? 1.f : 0.5f - 0.0025f * float(step);
        }
        const LinePartFinder finder = found_in(line);
        std::vector<float> now;
        for (std::size_t i = 0; i < 300; ++i)
            now.push_back(finder.opacity(i));
        for (std::size_t i = 0; i < before.size(); ++i)
            EXPECT_NEAR(now[i], before[i], 0.06) << "step " << step << ", point " << i;
        before = now;
    }
    EXPECT_EQ(before[299], 0);
}

TEST(LineParts, OfLinesWithoutLengthAreNone) {
    LinePartFinder finder;
    finder.find(whole_rules(), {{0, 0, 0, 0}, {0, 0, 0, 0}}, false);
    EXPECT_TRUE(finder.parts().empty());
    LineRules rules = whole_rules();
    rules.kernel_size = 0;
    EXPECT_NO_THROW(found_in(open_line(50), rules));
}

struct Drawn {
    std::size_t lines = 0;
    double length = 0;
};

Drawn drawn_of(const TriangleMesh& mesh, LineKind kind, bool whole) {
    PrecomputeOptions options;
    options.curvature_derivatives = kind != LineKind::Laplacian;
    const Field field = precompute(mesh, options);
    const LineExtractor extractor(mesh, field);
    LineStyle style;
    style.whole_lines = whole;
    style.shows = {};
    style.shows[kind] = true;
    LineSet lines;
    ExtractionScratch scratch;
    extractor.extract({Eigen::Vector3d(0.3, 0.4, 1), 0}, style, scratch, lines);
    Drawn drawn;
    for (const Polyline& line : lines.lines) {
        ++drawn.lines;
        drawn.length += double(line.length);
    }
    return drawn;
}

/// Tracing whole mends the dashes that texture cuts.
TEST(WholeLines, AreFewerAndLongerOnANoisySurface) {
    const TriangleMesh mesh = mesh_noise::with_noise(test_meshes::bumpy_sphere(5).mesh, 0.2, 3);
    for (const LineKind kind :
         {LineKind::Laplacian, LineKind::SuggestiveContour, LineKind::PhoticExtremum}) {
        const Drawn dashes = drawn_of(mesh, kind, false), whole = drawn_of(mesh, kind, true);
        EXPECT_GT(dashes.lines, 3u);
        EXPECT_GT(whole.length / double(whole.lines), 1.1 * dashes.length / double(dashes.lines))
            << int(kind) << ": " << dashes.lines << " and " << whole.lines << " lines";
    }
}

}  // namespace
