// SPDX-License-Identifier: GPL-3.0-or-later
// Files of parts, good and refused; drawings in place of exact lines.
#include "part_file.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <QByteArray>
#include <QFile>
#include <QTemporaryDir>

#include "../core/places.h"
#include "flat_drawing.h"
#include "generators.h"
#include "line_drawing/path.h"
#include "plane_canvas.h"

namespace {

using namespace benchmarks;

QString stored(const char* part) {
    return QString::fromStdString(
        (places::repository() / "programs/benchmarks/truth/parts" / (std::string(part) + ".part")).string());
}

class Files : public testing::Test {
protected:
    QString write(const QByteArray& bytes) const {
        QFile file(folder_.path() + "/file");
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return file.fileName();
    }

private:
    QTemporaryDir folder_;
};

using PartFile = Files;
using LeftOutFile = Files;

TEST_F(PartFile, HasMeshesAndLinesOfThePartsSize) {
    const CadPart part = read_part(stored("drilled_plate"));
    EXPECT_EQ(part.name, "drilled_plate");
    ASSERT_EQ(part.meshes.size(), 2u);
    ASSERT_EQ(part.views.size(), 5u);
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : part.meshes[0].mesh.positions)
        box.extend(p);
    EXPECT_NEAR((box.sizes() - Eigen::Vector3d(100, 70, 8)).norm(), 0, 1e-4);
    const ExactView& top = part.views[0];
    EXPECT_EQ(top.name, "00+ by 1e-6");
    EXPECT_EQ(top.direction_class, DirectionClass::AsideByAHair);
    EXPECT_NEAR((box_of(top.demanded).sizes() - Eigen::Vector2d(100, 70)).norm(), 0, 0.002);
}

TEST_F(PartFile, IsRefusedIfCutOrNotOne) {
    QFile file(stored("drilled_plate"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray raw = qUncompress(file.readAll());
    ASSERT_FALSE(raw.isEmpty());
    EXPECT_NO_THROW(read_part(write(qCompress(raw))));
    for (const int size : {0, 7, 8, 12, 40, 1000, raw.size() - 1})
        EXPECT_THROW(read_part(write(qCompress(raw.left(size)))), std::runtime_error) << size;
    EXPECT_THROW(read_part(write(qCompress(raw + "x"))), std::runtime_error);
    EXPECT_THROW(read_part(write("LLTRUTH1")), std::runtime_error);
    EXPECT_THROW(read_part(stored("no_part")), std::runtime_error);
}

TEST_F(LeftOutFile, NamesPartsAndDirections) {
    const LeftOut left_out(write("# a comment\nknob\t0-0\ta reason\n\nspring\t*\tanother\n"));
    EXPECT_TRUE(left_out.has("knob", "0-0"));
    EXPECT_FALSE(left_out.has("knob", "0-0 by 1e-6"));
    EXPECT_TRUE(left_out.has("spring", "00+"));
    EXPECT_FALSE(left_out.has("gear", "0-0"));
}

TEST_F(LeftOutFile, NeedsAReason) {
    EXPECT_THROW(LeftOut(write("knob\t0-0\n")), std::runtime_error);
    EXPECT_THROW(LeftOut(write("knob 0-0 because\n")), std::runtime_error);
}

/// Whatever the box's size and orientation.
TEST(FlatDrawing, IsInTheCoordinatesOfItsView) {
    laplacian_lines::TriangleMesh box = test_meshes::cube(2);
    for (Eigen::Vector3d& p : box.positions)
        p = {20 * p.x() + 7, 35 * p.y() - 3, 10 * p.z() + 50};
    const double a = 0.3;
    const PlaneFrame above = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const PlaneFrame turned = {
        {std::cos(a), std::sin(a), 0}, {-std::sin(a), std::cos(a), 0}, {0, 0, 1}};
    const auto drawn = drawings_of(box, {above, turned}, {2, {1, 0, 0}});
    const Eigen::AlignedBox2d ink = box_of(lines_of(drawn.at(0)));
    EXPECT_NEAR((ink.min() - Eigen::Vector2d(-28, -76)).norm(), 0, 0.05);
    EXPECT_NEAR((ink.max() - Eigen::Vector2d(52, 64)).norm(), 0, 0.05);
    const PlanePoint corner = 2 * turned.project({-14, 32, 0});
    EXPECT_NEAR(box_of(lines_of(drawn.at(1))).max().y(), corner.y(), 0.05);
}

TEST(FlatDrawing, HasCurvesAsLines) {
    line_drawing::SheetGroup view{"view", "View", {{"outline", "Outline", {}, {}}}};
    line_drawing::Path quarter;
    const double k = 0.5522847498;
    quarter.moveTo({10, 0});
    quarter.curveTo({10, 10 * k}, {10 * k, 10}, {0, 10});
    view.layers[0].paths = {{quarter, 0.5, 0}, {quarter, 0, 0}};  // a stroke and an area
    const DrawnPaths paths = flattened(view);
    ASSERT_EQ(paths.size(), 1u);
    EXPECT_TRUE(paths[0].is_outline);
    EXPECT_FALSE(paths[0].is_closed);
    for (std::size_t i = 0; i + 1 < paths[0].points.size(); ++i) {
        EXPECT_NEAR(paths[0].points[i].norm(), 10, 0.004);
        EXPECT_NEAR((paths[0].points[i] + paths[0].points[i + 1]).norm() / 2, 10, 0.006);
    }
}

}  // namespace
