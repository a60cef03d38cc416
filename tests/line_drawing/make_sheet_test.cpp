// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/make_sheet.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "laplacian_lines/error.h"
#include "laplacian_lines/refinement.h"
#include "line_drawing/sheet_file.h"
#include "sheet/sheet_annotations.h"
#include "sheet_helpers.h"
#include "with_threads.h"

using namespace line_drawing;
using sheet_helpers::cube_of100;
using sheet_helpers::extent_of;
using sheet_helpers::has;
using sheet_helpers::painter_path;
using sheet_helpers::plain_views;
using sheet_helpers::sheet_of;
using sheet_helpers::texts_of;

namespace {

/// SVG's layer names have to be unique.
TEST(MeasuredDrawing, OfOneViewTwiceTellsThemApart) {
    const Sheet sheet = sheet_of(cube_of100(), plain_views("front,front,front"));
    EXPECT_EQ(sheet.groups.at(0).key, "front");
    EXPECT_EQ(sheet.groups.at(1).key, "front-2");
    EXPECT_EQ(sheet.groups.at(2).key, "front-3");
}

/// Several threads look at views, but progress windows belong to one.
TEST(MeasuredDrawing, TellsProgressOnTheThreadThatAskedForIt) {
    const laplacian_lines::TriangleMesh vessel = test_meshes::thrown_vessel({150, 180});
    const auto here = std::this_thread::get_id();
    double last = 0;
    std::atomic<int> elsewhere{0};
    const test_meshes::WithThreads several(4);
    make_sheets({{vessel}}, {plain_views("six")}, [&](double done, const char*) {
        if (std::this_thread::get_id() != here) {
            ++elsewhere;
            return true;
        }
        EXPECT_GE(done, last);
        last = done;
        return true;
    });
    EXPECT_EQ(elsewhere, 0);
    EXPECT_EQ(last, 1);
}

/// File names may contain anything.
TEST(MeasuredDrawing, HasTextsOfOneLine) {
    SheetOptions options = plain_views("front");
    options.title = "A\nB\x01";
    options.source = "cube\r\n.ply";
    const Sheet sheet = sheet_of(cube_of100(), options);
    EXPECT_EQ(sheet.title, "A B ");
    EXPECT_TRUE(has(joined(texts_of(sheet), "|"), "A B "));
    EXPECT_TRUE(has(joined(texts_of(sheet), "|"), "cube  .ply"));
}

TEST(MeasuredDrawing, TellsSmallSizes) {
    SheetOptions options = plain_views("front");
    options.scale = 1000;
    const Sheet sheet = sheet_of(test_meshes::moved(cube_of100(), {0, 0, 0}, 1.2345e-5), options);
    const std::string texts = joined(texts_of(sheet), "|");
    EXPECT_TRUE(has(texts, "1.23 × 1.23 × 1.23 µm")) << texts;
}

/// Not that of the curved surface, which bulges.
TEST(MeasuredDrawing, TellsTheSizeOfTheMeshThatIsRefined) {
    const laplacian_lines::TriangleMesh mesh = test_meshes::bumpy_sphere(4).mesh,
                                        finer = laplacian_lines::refined(mesh);
    ASSERT_GT(finer.positions.size(), mesh.positions.size());
    EXPECT_EQ(bounds_of(finer).sizes(), bounds_of(mesh).sizes());
}

TEST(MeasuredDrawing, UnitsAndScalesMultiply) {
    SheetOptions options = plain_views("front");
    options.scale = 0.05;
    options.mm_per_unit = 10;
    const QRectF extent = extent_of(sheet_of(cube_of100(), options).groups[0]);
    EXPECT_NEAR(extent.width(), 50, 0.02);
}

TEST(MeasuredDrawing, KnowsTheKernelOfAGivenField) {
    const auto mesh = test_meshes::bumpy_sphere(4).mesh;
    const laplacian_lines::Field field = laplacian_lines::precompute(mesh);
    const laplacian_lines::LineExtractor extractor(mesh, field);
    const Objects objects = {{mesh, &field, {}, &extractor}};
    EXPECT_EQ(make_sheets(objects, {plain_views("front")})[0].kernel, field.scale.kernel_size);
}

TEST(MeasuredDrawing, ALightTurnsWithTheView) {
    const auto mesh = test_meshes::bumpy_sphere(4).mesh;
    laplacian_lines::PrecomputeOptions gentle;
    gentle.kernel_size = 0.135;
    const auto field = laplacian_lines::precompute(mesh, gentle);
    const auto svg = [&](const char* views, std::optional<Eigen::Vector3d> light) {
        SheetOptions options = plain_views(views);
        options.mm_per_unit = 40;
        options.light = light;
        return write_sheet(line_drawing::make_sheets({{mesh, &field}}, {options}).front(), ".svg");
    };
    EXPECT_EQ(svg("left", Eigen::Vector3d(0, 0, 2)), svg("left", {}));
    EXPECT_NE(svg("left", Eigen::Vector3d(-1, 1, 1)), svg("left", {}));
}

TEST(MeasuredDrawing, OutlinesOfASphereAreClosedCircles) {
    SheetOptions options = plain_views("front,30,40");
    options.mm_per_unit = 40;
    const Sheet sheet = sheet_of(test_meshes::sphere(5).mesh, options);
    for (std::size_t view = 0; view < 2; ++view) {
        const SheetLayer& outlines = sheet.groups[view].layers.back();
        ASSERT_EQ(outlines.key, "outline");
        ASSERT_EQ(outlines.paths.size(), 1u);
        const QPainterPath path = painter_path(outlines.paths[0].path);
        EXPECT_EQ(QPointF(path.elementAt(0)), path.currentPosition());
        EXPECT_NEAR(path.boundingRect().width(), 80, 0.1);
        EXPECT_LE(path.elementCount(), 3 * 16 + 1);
    }
}

/// By view and layer.
std::vector<double> lengths_of(const Sheet& sheet) {
    std::vector<double> lengths;
    for (const SheetGroup& view : sheet.groups)
        for (const SheetLayer& layer : view.layers)
            lengths.push_back(sheet_helpers::length_of(layer));
    return lengths;
}

TEST(MeasuredDrawing, IsThatOfTheWholeSurfaceAcrossCracks) {
    const laplacian_lines::TriangleMesh whole = cube_of100();
    laplacian_lines::TriangleMesh cracked = test_meshes::cut_apart(whole);
    for (std::size_t v = 0; v < cracked.positions.size(); ++v)
        cracked.positions[v].x() += 0.001 * double(v % 5);  // of 173 mm
    const SheetOptions options = sheet_helpers::with_sections("30,20", "z=0.4");
    const auto expected = lengths_of(sheet_of(whole, options)),
               found = lengths_of(sheet_of(cracked, options));
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 390) << "a section's is 400";
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 0.1);
}

TEST(MeasuredDrawing, HiddenEdgesAreDashedIfWanted) {
    SheetOptions options = plain_views("30,30");
    for (const bool wanted : {false, true}) {
        options.hidden = wanted ? HiddenLines::Dashed : HiddenLines::LeftOut;
        const Sheet sheet = sheet_of(cube_of100(), options);
        const SheetLayer& hidden = sheet.groups[0].layers.front();
        ASSERT_EQ(hidden.key, "hidden");
        double length = 0;
        for (const SheetPath& path : hidden.paths) {
            length += painter_path(path.path).length();
            EXPECT_GT(path.dash, 0);
            EXPECT_EQ(path.pen_width, options.pens[std::size_t(LineClass::Hidden)]);
        }
        // Three edges, from 30° above: one upright, two lying, turned by 30° to the view.
        const double lying = std::hypot(std::cos(M_PI / 6), std::sin(M_PI / 6) * 0.5) +
                             std::hypot(0.5, std::cos(M_PI / 6) * 0.5);
        EXPECT_NEAR(length, wanted ? 100 * (std::cos(M_PI / 6) + lying) : 0, 1);
    }
}

TEST(MeasuredDrawing, RefusesWhatCannotBeDrawn) {
    const auto mesh = cube_of100();
    const auto refused = [&](const auto& change) {
        SheetOptions options = plain_views("front");
        change(options);
        EXPECT_THROW(sheet_of(mesh, options), laplacian_lines::Error);
    };
    EXPECT_THROW(make_sheets({}, {plain_views("front")}), laplacian_lines::Error);
    refused([](SheetOptions& o) { o.views.clear(); });
    refused([](SheetOptions& o) { o.mm_per_unit = 0; });
    refused([](SheetOptions& o) { o.mm_per_unit = std::nan(""); });
    refused([](SheetOptions& o) { o.pens[1] = -1; });
    refused([](SheetOptions& o) { o.scale = 100; });
    refused([](SheetOptions& o) { o.paper = "foolscap"; });
    refused([](SheetOptions& o) { o.style.detail = 1000; });
}

TEST(MeasuredDrawing, CanBeCancelled) {
    const auto mesh = cube_of100();
    const auto field = laplacian_lines::precompute(mesh);
    EXPECT_THROW(make_sheets({{mesh, &field}}, {plain_views("six")},
                             [](double done, const char*) { return done < 0.6; }),
                 laplacian_lines::Error);
}

ContactEntry entry_of(const laplacian_lines::TriangleMesh& mesh, const char* name) {
    SheetOptions options;
    options.views = parse_views("front,left", UpAxis::Z);
    return {name, sheet_of(mesh, contact_options(mesh, options))};
}

std::vector<ContactEntry> cubes(int count) {
    return std::vector<ContactEntry>(std::size_t(count), entry_of(cube_of100(), "a cube"));
}

TEST(ContactSheets, HoldAllViewsWithoutOverlapOnOnePage) {
    for (const int count : {1, 2, 6, 13, 40, 200}) {
        const Sheet sheet = make_contact_sheet(cubes(count), "Cubes");
        ASSERT_EQ(sheet.groups.size(), std::size_t(count) + 1);
        const QRectF page = sheet_helpers::paper_of(sheet.size);
        for (int i = 0; i < count; ++i) {
            const QRectF place = extent_of(sheet.groups[std::size_t(i)]);
            EXPECT_GT(place.width(), 30) << count;
            EXPECT_NEAR(place.width(), place.height(), 0.2);
            EXPECT_TRUE(page.contains(place));
            EXPECT_EQ(sheet.groups[std::size_t(i)].layers.back().texts[0].text, "a cube");
            for (int k = 0; k < i; ++k)
                EXPECT_FALSE(place.intersects(extent_of(sheet.groups[std::size_t(k)])));
        }
    }
    EXPECT_TRUE(make_contact_sheet({}, "").groups.empty());
}

TEST(ContactSheets, CutLongTitles) {
    const Sheet sheet = make_contact_sheet(cubes(1), std::string(500, 'W'));
    EXPECT_EQ(sheet.remarks.size(), 1u);
    ASSERT_FALSE(sheet.groups.back().layers.at(0).texts.empty());
    for (const SheetText& text : sheet.groups.back().layers.at(0).texts)
        EXPECT_LT(width_in_any_font(text.text, text.height), sheet.size.x() - 20);
}

TEST(ContactSheets, HaveTheWeightsAndDashesOfTheOptions) {
    SheetOptions options = plain_views("30,20");
    options.pens = pens_of(Weights::Iso);
    options.hidden = HiddenLines::Dashed;
    const SheetOptions of_contact = contact_options(cube_of100(), options);
    const auto pen = [&](LineClass c) { return of_contact.pens[std::size_t(c)]; };
    EXPECT_EQ(pen(LineClass::Outline), 0.35);  // a step finer
    EXPECT_EQ(pen(LineClass::Edge), 0.35);
    const ContactEntry entry = {"cube", sheet_of(cube_of100(), of_contact)};
    const Sheet sheet = make_contact_sheet(std::vector<ContactEntry>(40, entry), "");
    const SheetPath &whole = sheet_helpers::layer_of(entry.view.groups[0], "hidden").paths.at(0),
                    &small = sheet_helpers::layer_of(sheet.groups[0], "hidden").paths.at(0);
    EXPECT_LT(small.pen_width, 0.9 * whole.pen_width);
    EXPECT_NEAR(small.dash / whole.dash, small.pen_width / whole.pen_width, 1e-9);
}

TEST(ContactSheets, AreAtScale) {
    SheetOptions options = plain_views("front");
    options.views[0].eye = Eigen::Vector3d(0, 0, 300);
    EXPECT_FALSE(contact_options(cube_of100(), options).views.at(0).eye);
}

TEST(ContactSheets, TellSizes) {
    const ContactEntry entry = entry_of(cube_of100(), "cube");
    EXPECT_EQ(entry.view.groups.size(), 1u);  // one view, no annotations
    EXPECT_EQ(make_contact_sheet({entry}, "").groups[0].layers.back().texts[1].text,
              "100.0 × 100.0 × 100.0 mm");
}

}  // namespace
