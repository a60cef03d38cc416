// SPDX-License-Identifier: GPL-3.0-or-later
// A window shows what is printed of its view.
#include "line_drawing/view_painter.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QRect>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "line_drawing/sheet_file.h"
#include "made_sheets.h"

using namespace line_drawing;

namespace {

constexpr int side = 2600;  // of the window, pixels
constexpr double pixels_per_mm = 10;

laplacian_lines::TriangleMesh vessel() {
    return test_meshes::thrown_vessel({150, 180});
}

/// Of the width `width`, mesh units, at `distance` before the eye, or in a parallel view.
WindowView windowOf(const ViewFrame& frame, double width, double distance,
                    const Eigen::Vector3d& middle = {0, 0, 0}) {
    Eigen::Matrix4d to_eye = Eigen::Matrix4d::Identity(), projection = to_eye;
    to_eye.topLeftCorner<3, 3>() << frame.right.transpose(), frame.up.transpose(),
        frame.towards_viewer.transpose();
    to_eye.topRightCorner<3, 1>() = -to_eye.topLeftCorner<3, 3>() * frame.eye.value_or(middle);
    if (frame.eye) {
        projection.topLeftCorner<2, 2>() *= 2 * distance / width;
        projection.bottomRows<2>() << 0, 0, -1, -1, 0, 0, -1, 0;
    } else {
        projection.topLeftCorner<2, 2>() *= 2 / width;
    }
    return {frame, projection * to_eye, {side, side}, pixels_per_mm};
}

PaintedView painted(ViewPainter& painter, const WindowView& view, const SheetOptions& options) {
    return painter.paint(view, options, {Ink()}, true);
}

QImage imageOf(const PaintedView& picture) {
    return QImage(picture.inks.at(0).data(), picture.size.x(), picture.size.y(), picture.size.x(),
                  QImage::Format_Grayscale8)
        .copy();
}

bool isInk(const QImage& image, const QPoint& at) {
    return image.valid(at) && qGray(image.pixel(at)) < 128;
}

QRect inkOf(const QImage& image) {
    QRect ink;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (isInk(image, {x, y})) ink = ink.united(QRect(x, y, 1, 1));
    return ink;
}

/// Of the ink of one picture, that within a pixel of the other's, once both begin at the same
/// place.
double shareIn(const QImage& of, const QImage& in) {
    const QRect ink = inkOf(of);
    const QPoint shift = inkOf(in).topLeft() - ink.topLeft();
    int all = 0, shared = 0;
    for (int y = ink.top(); y <= ink.bottom(); ++y)
        for (int x = ink.left(); x <= ink.right(); ++x) {
            if (!isInk(of, {x, y})) continue;
            ++all;
            for (int near = 0; near < 9; ++near)
                if (isInk(in, shift + QPoint(x + near / 3 - 1, y + near % 3 - 1))) {
                    ++shared;
                    break;
                }
        }
    return all ? double(shared) / all : 0;
}

SheetOptions plain(const char* views) {
    SheetOptions options;
    options.views = parseViews(views, UpAxis::Z);
    options.has_furniture = false;
    return options;
}

/// Of the sheet at the window's resolution.
QImage printed(const laplacian_lines::TriangleMesh& mesh, const SheetOptions& options) {
    const Sheet sheet = makeSheets({{mesh}}, {options}).front();
    return QImage::fromData(
        QByteArray::fromStdString(writeSheet(sheet, ".png", 25.4 * pixels_per_mm)));
}

void expectEqual(const QImage& a, const QImage& b) {
    EXPECT_NEAR(inkOf(a).width(), inkOf(b).width(), 1);
    EXPECT_GE(shareIn(a, b), 0.99);
    EXPECT_GE(shareIn(b, a), 0.99);
}

TEST(ViewPainter, PaintsWhatIsPrinted) {
    const laplacian_lines::TriangleMesh mesh = vessel();
    SheetOptions options = plain("20,30");
    options.scale = 1;
    options.paper = "a3";
    const QImage sheet = printed(mesh, options);
    ViewPainter painter({{mesh}});
    const WindowView window =
        windowOf(options.views[0], side / pixels_per_mm, 0, boundsOf(mesh).center());
    expectEqual(imageOf(painted(painter, window, options)), sheet);
}

TEST(ViewPainter, PaintsWhatIsPrintedInPerspective) {
    const laplacian_lines::TriangleMesh mesh = vessel();
    const double size = boundsOf(mesh).diagonal().norm();
    SheetOptions options = plain("20,30");
    ViewFrame& frame = options.views[0];
    frame.eye = boundsOf(mesh).center() + 1.5 * size * frame.towards_viewer;
    const QImage sheet = printed(mesh, options);
    ViewPainter painter({{mesh}});
    const auto widthOf = [&](const QImage& image) {  // between the middles of outlines
        return inkOf(image).width() - options.pens[std::size_t(LineClass::Outline)] * pixels_per_mm;
    };
    WindowView window = windowOf(frame, size, 1.5 * size);
    const double drawn = widthOf(imageOf(painted(painter, window, options)));
    window = windowOf(frame, size * drawn / widthOf(sheet), 1.5 * size);  // as large as on paper
    expectEqual(imageOf(painted(painter, window, options)), sheet);
}

TEST(ViewPainter, GivesUpAtOnceAndGoesOnLater) {
    const laplacian_lines::TriangleMesh mesh = test_meshes::thrown_vessel({50, 60});
    const SheetOptions options = plain("front");
    WindowView window = windowOf(options.views[0], 3 * boundsOf(mesh).diagonal().norm(), 0);
    window.size = {800, 800};
    laplacian_lines::TriangleMesh beside = mesh;
    for (Eigen::Vector3d& p : beside.positions)
        p.x() += 2 * boundsOf(mesh).sizes().x();
    const Objects objects = {{mesh}, {beside}};
    ViewPainter painter(objects);
    const PaintedView whole = painted(painter, window, options);
    for (const double end : {0.0, 0.2, 0.5, 0.6, 0.8}) {
        ViewPainter other(objects);
        const auto until = [=](double done, const char*) { return done < end; };
        EXPECT_THROW(other.paint(window, options, {Ink()}, true, until), laplacian_lines::Error)
            << end;
        EXPECT_EQ(painted(other, window, options).inks, whole.inks) << end;
    }
}

/// Whoever cannot wait gets lines of another kernel, until those of the view are there.
TEST(ViewPainter, PaintsWhatIsAtHand) {
    const laplacian_lines::TriangleMesh mesh = vessel();
    const laplacian_lines::Field field = laplacian_lines::precompute(mesh);
    const laplacian_lines::LineExtractor extractor(mesh, field);
    SheetOptions options = plain("20,30");
    options.scale = 1;
    ViewPainter painter({{mesh, nullptr, {}, &extractor, field.scale.kernel_size}});
    const WindowView window =
        windowOf(options.views[0], side / pixels_per_mm, 0, boundsOf(mesh).center());
    const auto paint = [&](bool may_wait) {
        return painter.paint(window, options, {Ink()}, may_wait);
    };
    const PaintedView first = paint(false), second = paint(true), third = paint(false);
    EXPECT_FALSE(first.is_final);
    EXPECT_GT(shareIn(imageOf(second), imageOf(first)), 0.8);
    EXPECT_TRUE(second.is_final);
    EXPECT_TRUE(third.is_final);
    EXPECT_EQ(third.inks, second.inks);
    ViewPainter other({{mesh}});
    EXPECT_EQ(painted(other, window, options).inks, second.inks);
}

TEST(ViewPainter, RefusesAnEyeInsideTheSurface) {
    const laplacian_lines::TriangleMesh mesh = made_sheets::cubeOf100();
    SheetOptions options = plain("front");
    options.views[0].eye = Eigen::Vector3d(0, 0, 0);
    ViewPainter painter({{mesh}});
    EXPECT_THROW(painted(painter, windowOf(options.views[0], 1, 1), options),
                 laplacian_lines::Error);
}

}  // namespace
