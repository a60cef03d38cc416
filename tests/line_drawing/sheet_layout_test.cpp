// SPDX-License-Identifier: GPL-3.0-or-later
// Where views are on paper; its size decides about kernel and pens.
#include <gtest/gtest.h>

#include <cmath>

#include "laplacian_lines/error.h"
#include "sheet_helpers.h"

using namespace line_drawing;
using laplacian_lines::TriangleMesh;
using sheet_helpers::extent_of;
using sheet_helpers::plain_views;

namespace {

/// Of 60 x 40 x 20 mm if not of other half sides.
TriangleMesh box(const Eigen::Vector3d& half = {30, 20, 10}) {
    return test_meshes::mapped(test_meshes::cube(2),
                               [&](Eigen::Vector3d& p) { p = p.cwiseProduct(half); });
}

SheetOptions fitting(const char* views, const char* paper = "a4") {
    SheetOptions options = plain_views(views, paper);
    options.scale = 0;
    return options;
}

Sheet sheet_of(const SheetOptions& options) {
    return sheet_helpers::sheet_of(box(), options);
}

/// Of the views, which are on the paper without overlap.
std::vector<QRectF> places_of(const SheetOptions& options) {
    const Sheet sheet = sheet_of(options);
    std::vector<QRectF> places;
    for (const SheetGroup& group : sheet.groups)
        if (group.key != "sheet") places.push_back(extent_of(group));
    const QRectF paper = sheet_helpers::paper_of(sheet.size);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_TRUE(paper.contains(places[i])) << i;
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(places[i].intersects(places[k])) << i << ' ' << k;
    }
    return places;
}

TEST(SheetLayout, AlignsTheViewsInFirstAngle) {
    const auto at = places_of(fitting("six"));  // front, back, left, right, top, bottom
    for (const std::size_t beside : {1, 2, 3})
        EXPECT_NEAR(at[beside].top(), at[0].top(), 0.02);
    for (const std::size_t above : {4, 5})
        EXPECT_NEAR(at[above].left(), at[0].left(), 0.02);
    EXPECT_GT(at[2].left(), at[0].right());  // from the left on the right
    EXPECT_LT(at[3].right(), at[0].left());
    EXPECT_GT(at[4].top(), at[0].bottom());  // from above below
    EXPECT_LT(at[5].bottom(), at[0].top());
}

TEST(SheetLayout, TurnsTheArrangementInThirdAngle) {
    SheetOptions options = fitting("front,left,top,back");
    options.arrangement = Arrangement::ThirdAngle;
    const auto at = places_of(options);
    EXPECT_LT(at[1].right(), at[0].left());
    EXPECT_LT(at[2].bottom(), at[0].top());
    EXPECT_GT(at[3].left(), at[0].right());
}

TEST(SheetLayout, ViewsWithoutWidthHaveGapsToo) {
    SheetOptions options = fitting("front,left");
    options.arrangement = Arrangement::ThirdAngle;
    const Sheet sheet = sheet_helpers::sheet_of(box({30, 20, 0}), options);
    EXPECT_NEAR(extent_of(sheet.groups[0]).left() - extent_of(sheet.groups[1]).right(), 10, 1);
}

/// Thirty sections in one row would not fit at any scale.
TEST(SheetLayout, ManyViewsStandInRows) {
    EXPECT_EQ(places_of(fitting("six 30,15 60,15 90,40 0,10 45,45")).size(), 11u);
    for (const char* views : {"front", "front,top"}) {
        SheetOptions options = fitting(views);
        options.sections.resize(30);
        EXPECT_EQ(places_of(options).size(), options.views.size() + 30);
        EXPECT_GE(sheet_of(options).scale, 0.2);
    }
}

/// A column of upright bars, or a row of lying ones, would be half as large.
TEST(SheetLayout, ViewsOfNoSideAreBesideTallObjects) {
    for (const bool upright : {true, false}) {
        const TriangleMesh bar = upright ? box({30, 20, 80}) : box({120, 20, 10});
        const Sheet sheet = sheet_helpers::sheet_of(bar, fitting("front,30,25"));
        const QRectF front = extent_of(sheet.groups[0]), other = extent_of(sheet.groups[1]);
        EXPECT_EQ(other.left() > front.right(), upright);
        EXPECT_EQ(other.top() > front.bottom(), !upright);
    }
}

TEST(SheetLayout, TheOnlySectionIsBelowIfItHasNoPlaceBeside) {
    SheetOptions options = fitting("front");
    options.sections.resize(1);
    options.scale = 0.56;  // 269 mm of 277, and the section is 11 mm wide
    const Sheet sheet = sheet_helpers::sheet_of(box({240, 20, 10}), options);
    EXPECT_GT(extent_of(sheet.groups[1]).top(), extent_of(sheet.groups[0]).bottom());
}

TEST(SheetLayout, TakesTheLargestUsualScaleThatFits) {
    EXPECT_EQ(sheet_of(fitting("front")).scale, 4);  // 240 mm on lying A4
    EXPECT_EQ(sheet_of(fitting("front", "a5")).scale, 2);
    EXPECT_EQ(sheet_helpers::sheet_of(box({30, 10, 21.5}), fitting("front")).scale, 4)
        << "172 mm of 174 high, and no name below it";
    for (const char* name : paper_names())
        EXPECT_GT(sheet_of(fitting("front", name)).size.x(), 100) << name;
}

TEST(SheetLayout, PaperCanBeAsLargeAsTheDrawing) {
    SheetOptions options = fitting("front", "fit");
    options.scale = 10;
    EXPECT_NEAR(sheet_of(options).size.x(), 600, 50);
    EXPECT_GT(sheet_of(options).size.x(), 600);
}

TEST(SheetLayout, PaperHasRoomForBarSymbolAndNote) {
    SheetOptions options = fitting("front,left", "fit");
    EXPECT_TRUE(sheet_of(options).remarks.empty());
    options.scale = 0.1;
    const Sheet sheet = sheet_of(options);
    EXPECT_TRUE(sheet.remarks.empty()) << joined(sheet.remarks, " ");
}

TEST(SheetLayout, ScalesHaveNames) {
    EXPECT_EQ(parse_scale("1:2"), 0.5);
    EXPECT_EQ(parse_scale("5:2"), 2.5);
    EXPECT_EQ(parse_scale("fit"), 0);
    EXPECT_EQ(scale_text(0.5), "1:2");
    EXPECT_EQ(scale_text(20), "20:1");
    EXPECT_EQ(kernel_text(99.6), "100");
    for (const char* word :
         {"", "2", "1:0", "-1:2", "1:2:3", "a:b", "nan:1", "1:inf", "1:1e308", "1e308:1"})
        EXPECT_THROW(parse_scale(word), laplacian_lines::Error) << word;
}

TEST(SheetAnnotations, LongTitlesAreWhole) {
    SheetOptions options = plain_views("front", "a4");
    for (int i = 0; i < 30; ++i)
        options.title += (i ? " word" : "word") + std::to_string(i);
    const auto title_of = [&] {
        const Sheet sheet = sheet_of(options);
        Words lines;
        for (const SheetText& text : sheet_helpers::layer_of(sheet.groups.back(), "title").texts)
            if (text.text.find("word") != text.text.npos) lines.insert(lines.begin(), text.text);
        return joined(lines, " ");
    };
    EXPECT_EQ(title_of(), options.title);
    options.title += options.title + options.title + options.title;
    EXPECT_TRUE(ends_with(title_of(), "…"));
}

/// About 100 mm wide, mean edges of about 1 mm.
laplacian_lines::TriangleMesh bumpy_sphere() {
    return test_meshes::moved(test_meshes::bumpy_sphere(6).mesh, {0, 0, 0}, 50);
}

SheetOptions options_at(double scale) {
    SheetOptions options = sheet_helpers::plain_views("front");
    options.scale = scale;
    return options;
}

Sheet draw(const laplacian_lines::TriangleMesh& mesh, const SheetOptions& options) {
    return make_sheets({{mesh}}, {options}).front();
}

/// mm on paper, from the sheet's note.
double kernel_of(const Sheet& sheet) {
    const std::string texts = joined(sheet_helpers::texts_of(sheet), "|");
    const std::size_t at = texts.find("√h ");
    return at == texts.npos ? 0 : std::stod(texts.substr(at + 5));
}

double thickest(const Sheet& sheet) {
    double width = 0;
    for (const SheetLayer& layer : sheet.groups[0].layers)
        for (const SheetPath& path : layer.paths)
            width = std::max(width, path.pen_width);
    return width;
}

TEST(PrintedSize, DecidesAboutTheKernel) {
    const auto mesh = bumpy_sphere();
    const double edge = laplacian_lines::measure_scale(mesh, {}).mean_edge;
    EXPECT_NEAR(kernel_of(draw(mesh, options_at(0.4))), 1, 0.03);  // four pens of .25 mm
    // At least a mean edge.
    EXPECT_NEAR(kernel_of(draw(mesh, options_at(2))), 2 * edge, 0.05 * 2 * edge);
}

TEST(PrintedSize, DetailChangesTheKernel) {
    const auto mesh = bumpy_sphere();
    const auto kernel_at = [&](double scale, double detail, const char* kernel = "auto") {
        SheetOptions options = options_at(scale);
        options.style.detail = detail;
        options.kernel = parse_detail_size(kernel);
        return kernel_of(draw(mesh, options));
    };
    EXPECT_NEAR(kernel_at(0.4, 0), 2, 0.06);
    EXPECT_NEAR(kernel_at(0.4, 25), std::sqrt(2), 0.05);
    EXPECT_NEAR(kernel_at(0.4, 75), std::sqrt(0.5), 0.02);
    EXPECT_NEAR(kernel_at(2, 100), kernel_at(2, 50) / 2, 0.01 * kernel_at(2, 50));
    EXPECT_NEAR(kernel_at(0.4, 100, "2mm"), 2, 0.06) << "asked for";
}

TEST(PrintedSize, DecidesAboutPens) {
    const auto mesh = sheet_helpers::cube_of100();
    EXPECT_EQ(thickest(draw(mesh, options_at(1))), 0.5);
    EXPECT_EQ(thickest(draw(mesh, options_at(0.41))), 0.5);
    EXPECT_EQ(thickest(draw(mesh, options_at(0.35))), 0.35);
    EXPECT_EQ(thickest(draw(mesh, options_at(0.2))), 0.25);
    EXPECT_EQ(thickest(draw(mesh, options_at(0.01))), 0.25);
    const Sheet small = draw(mesh, options_at(0.1));
    EXPECT_EQ(thickest(small), 0.25);
    for (const SheetLayer& layer : small.groups[0].layers)
        for (const SheetPath& path : layer.paths)
            EXPECT_GE(path.pen_width, 0.1);
}

TEST(PrintedSize, AGivenKernelIsUsedAsItIs) {
    const auto mesh = bumpy_sphere();
    SheetOptions options = options_at(0.5);
    options.kernel = parse_detail_size("2.5mm");
    SheetOptions smaller = options;
    smaller.scale = 0.25;
    for (const Sheet& sheet : make_sheets({{mesh}}, {options, smaller}))
        EXPECT_NEAR(kernel_of(sheet), 2.5, 0.03);
    options.kernel = parse_detail_size("2%");
    const double diagonal = laplacian_lines::measure_scale(mesh, {}).diagonal;
    EXPECT_NEAR(kernel_of(draw(mesh, options)), 0.02 * diagonal * 0.5, 0.05);
}

TEST(PrintedSize, AFieldOfTheUsersIsDrawnAsItIs) {
    const auto mesh = bumpy_sphere();
    laplacian_lines::PrecomputeOptions computed;
    computed.kernel_size = 4;
    const auto field = laplacian_lines::precompute(mesh, computed);
    const Sheet sheet = make_sheets({{mesh, &field}}, {options_at(0.5)}).front();
    EXPECT_NEAR(kernel_of(sheet), 2, 0.03);
    EXPECT_NEAR(sheet.kernel, 2, 1e-3);
}

TEST(PrintedSize, DetailIsALengthOnPaperOrAShare) {
    EXPECT_EQ(parse_detail_size(" Auto ").size, 0);
    EXPECT_EQ(parse_detail_size("1mm").size, 1);
    EXPECT_FALSE(parse_detail_size("0.35 mm").is_share);
    EXPECT_TRUE(parse_detail_size("0.9%").is_share);
    EXPECT_DOUBLE_EQ(parse_detail_size("0.9%").size, 0.009);
    for (const char* wrong : {"", "1", "mm", "-1mm", "0mm", "1e9mm", "nan%", "1cm"})
        EXPECT_THROW(parse_detail_size(wrong), laplacian_lines::Error) << wrong;
}

}  // namespace
