// SPDX-License-Identifier: GPL-3.0-or-later
// Size on paper decides about kernel and pens.
#include <gtest/gtest.h>

#include <cmath>

#include "laplacian_lines/error.h"
#include "made_sheets.h"

using namespace line_drawing;

namespace {

/// 100 mm wide, mean edges of about 1.3 mm.
laplacian_lines::TriangleMesh bumpySphere() {
    laplacian_lines::TriangleMesh mesh = test_meshes::bumpy_sphere(6).mesh;
    for (Eigen::Vector3d& p : mesh.positions)
        p *= 50;
    return mesh;
}

SheetOptions optionsAt(double scale) {
    SheetOptions options = made_sheets::plainViews("front");
    options.scale = scale;
    return options;
}

Sheet draw(const laplacian_lines::TriangleMesh& mesh, const SheetOptions& options) {
    return makeSheets({{mesh}}, {options}).front();
}

/// mm on paper, from the sheet's note.
double kernelOf(const Sheet& sheet) {
    for (const SheetGroup& group : sheet.groups)
        for (const SheetLayer& layer : group.layers)
            for (const SheetText& text : layer.texts) {
                const std::size_t at = text.text.find("√h ");
                if (at != text.text.npos) return std::stod(text.text.substr(at + 5));
            }
    return 0;
}

double thickest(const Sheet& sheet) {
    double width = 0;
    for (const SheetLayer& layer : sheet.groups[0].layers)
        for (const SheetPath& path : layer.paths)
            width = std::max(width, path.pen_width);
    return width;
}

TEST(PrintedSize, DecidesAboutTheKernel) {
    const auto mesh = bumpySphere();
    const double edge = laplacian_lines::measure_scale(mesh, {}).mean_edge;
    EXPECT_NEAR(kernelOf(draw(mesh, optionsAt(0.4))), 1, 0.03);  // four pens of .25 mm
    // At least a mean edge.
    EXPECT_NEAR(kernelOf(draw(mesh, optionsAt(2))), 2 * edge, 0.05 * 2 * edge);
}

TEST(PrintedSize, DecidesAboutPens) {
    const auto mesh = made_sheets::cubeOf100();
    EXPECT_EQ(thickest(draw(mesh, optionsAt(1))), 0.5);
    EXPECT_EQ(thickest(draw(mesh, optionsAt(0.41))), 0.5);
    EXPECT_EQ(thickest(draw(mesh, optionsAt(0.35))), 0.35);
    EXPECT_EQ(thickest(draw(mesh, optionsAt(0.2))), 0.25);
    EXPECT_EQ(thickest(draw(mesh, optionsAt(0.01))), 0.25);
    for (const SheetLayer& layer : draw(mesh, optionsAt(0.1)).groups[0].layers)
        for (const SheetPath& path : layer.paths)
            EXPECT_GE(path.pen_width, 0.1);
}

TEST(PrintedSize, AGivenKernelIsUsedAsItIs) {
    const auto mesh = bumpySphere();
    SheetOptions options = optionsAt(0.5);
    options.kernel = parseDetailSize("2.5mm");
    EXPECT_NEAR(kernelOf(draw(mesh, options)), 2.5, 0.03);
    options.kernel = parseDetailSize("2%");
    const double diagonal = laplacian_lines::measure_scale(mesh, {}).diagonal;
    EXPECT_NEAR(kernelOf(draw(mesh, options)), 0.02 * diagonal * 0.5, 0.05);
}

TEST(PrintedSize, AFieldOfTheUsersIsDrawnAsItIs) {
    const auto mesh = bumpySphere();
    laplacian_lines::PrecomputeOptions computed;
    computed.kernel_size = 4;
    const auto field = laplacian_lines::precompute(mesh, computed);
    const Sheet sheet = makeSheet(mesh, field, optionsAt(0.5));
    EXPECT_NEAR(kernelOf(sheet), 2, 0.03);
    EXPECT_NEAR(sheet.kernel, 2, 1e-3);
}

TEST(PrintedSize, DetailIsALengthOnPaperOrAShare) {
    EXPECT_EQ(parseDetailSize(" Auto ").size, 0);
    EXPECT_EQ(parseDetailSize("1mm").size, 1);
    EXPECT_FALSE(parseDetailSize("0.35 mm").is_share);
    EXPECT_TRUE(parseDetailSize("0.9%").is_share);
    EXPECT_DOUBLE_EQ(parseDetailSize("0.9%").size, 0.009);
    for (const char* wrong : {"", "1", "mm", "-1mm", "0mm", "1e9mm", "nan%", "1cm"})
        EXPECT_THROW(parseDetailSize(wrong), laplacian_lines::Error) << wrong;
}

}  // namespace
