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
#include "sheet_helpers.h"

using namespace line_drawing;

namespace {

constexpr int kSide = 2600;  // of the window, pixels
constexpr double kPixelsPerMm = 10;

laplacian_lines::TriangleMesh vessel() {
    return test_meshes::thrown_vessel({150, 180});
}

/// Of the width `width`, mesh units, at `distance` before the eye, or in a parallel view.
WindowView window_of(const ViewFrame& frame, double width, double distance,
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
    return {frame, projection * to_eye, {kSide, kSide}, kPixelsPerMm};
}

PaintedView painted(ViewPainter& painter, const WindowView& view, const SheetOptions& options) {
    return painter.paint(view, options, {Ink()}, true);
}

QImage image_of(const PaintedView& picture) {
    return QImage(picture.inks.at(0).data(), picture.size.x(), picture.size.y(), picture.size.x(),
                  QImage::Format_Grayscale8)
        .copy();
}

bool is_ink(const QImage& image, const QPoint& at) {
    return image.valid(at) && qGray(image.pixel(at)) < 128;
}

QRect ink_of(const QImage& image) {
    QRect ink;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (is_ink(image, {x, y})) ink = ink.united(QRect(x, y, 1, 1));
    return ink;
}

/// Of the ink of one picture, that within a pixel of the other's, once both begin at the same
/// place.
double share_in(const QImage& of, const QImage& in) {
    const QRect ink = ink_of(of);
    const QPoint shift = ink_of(in).topLeft() - ink.topLeft();
    int all = 0, shared = 0;
    for (int y = ink.top(); y <= ink.bottom(); ++y)
        for (int x = ink.left(); x <= ink.right(); ++x) {
            if (!is_ink(of, {x, y})) continue;
            ++all;
            for (int near = 0; near < 9; ++near)
                if (is_ink(in, shift + QPoint(x + near / 3 - 1, y + near % 3 - 1))) {
                    ++shared;
                    break;
                }
        }
    return all ? double(shared) / all : 0;
}

SheetOptions plain(const char* views) {
    SheetOptions options;
    options.views = parse_views(views, UpAxis::Z);
    options.has_annotations = false;
    return options;
}

/// Of the sheet at the window's resolution.
QImage printed(const laplacian_lines::TriangleMesh& mesh, const SheetOptions& options) {
    const Sheet sheet = make_sheets({{mesh}}, {options}).front();
    return QImage::fromData(
        QByteArray::fromStdString(write_sheet(sheet, ".png", 25.4 * kPixelsPerMm)));
}

void expect_equal(const QImage& a, const QImage& b) {
    EXPECT_NEAR(ink_of(a).width(), ink_of(b).width(), 1);
    EXPECT_GE(share_in(a, b), 0.99);
    EXPECT_GE(share_in(b, a), 0.99);
}

TEST(ViewPainter, PaintsWhatIsPrinted) {
    const laplacian_lines::TriangleMesh mesh = vessel();
    SheetOptions options = plain("20,30");
    options.scale = 1;
    options.paper = "a3";
    const QImage sheet = printed(mesh, options);
    ViewPainter painter({{mesh}});
    const WindowView window =
        window_of(options.views[0], kSide / kPixelsPerMm, 0, bounds_of(mesh).center());
    expect_equal(image_of(painted(painter, window, options)), sheet);
}

TEST(ViewPainter, PaintsWhatIsPrintedInPerspective) {
    const laplacian_lines::TriangleMesh mesh = vessel();
    const double size = bounds_of(mesh).diagonal().norm();
    SheetOptions options = plain("20,30");
    ViewFrame& frame = options.views[0];
    frame.eye = bounds_of(mesh).center() + 1.5 * size * frame.towards_viewer;
    const QImage sheet = printed(mesh, options);
    ViewPainter painter({{mesh}});
    const auto width_of = [&](const QImage& image) {  // between the middles of outlines
        return ink_of(image).width() - options.pens[std::size_t(LineClass::Outline)] * kPixelsPerMm;
    };
    WindowView window = window_of(frame, size, 1.5 * size);
    const double drawn = width_of(image_of(painted(painter, window, options)));
    window = window_of(frame, size * drawn / width_of(sheet), 1.5 * size);  // as large as on paper
    expect_equal(image_of(painted(painter, window, options)), sheet);
}

TEST(ViewPainter, GivesUpAtOnceAndGoesOnLater) {
    const laplacian_lines::TriangleMesh mesh = test_meshes::thrown_vessel({50, 60});
    const SheetOptions options = plain("front");
    WindowView window = window_of(options.views[0], 3 * bounds_of(mesh).diagonal().norm(), 0);
    window.size = {800, 800};
    const auto beside = test_meshes::moved(mesh, {2 * bounds_of(mesh).sizes().x(), 0, 0});
    const Objects objects = {{mesh}, {beside}};
    ViewPainter painter(objects);
    const PaintedView whole = painted(painter, window, options);
    ASSERT_FALSE(ink_of(image_of(whole)).isEmpty());
    for (const double end : {0.0, 0.2, 0.5, 0.6, 0.8}) {
        ViewPainter other(objects);
        const auto until = [=](double done, const char*) { return done < end; };
        EXPECT_THROW(other.paint(window, options, {Ink()}, true, until), laplacian_lines::Error)
            << end;
        EXPECT_EQ(painted(other, window, options).inks, whole.inks) << end;
    }
}

/// Whoever cannot wait gets lines of another kernel, until those of the view are there.
TEST(ViewPainter, PaintsTheNearestKernel) {
    const laplacian_lines::TriangleMesh mesh = vessel();
    const laplacian_lines::Field field = laplacian_lines::precompute(mesh);
    const laplacian_lines::LineExtractor extractor(mesh, field);
    SheetOptions options = plain("20,30");
    options.scale = 1;
    ViewPainter painter({{mesh, nullptr, {}, &extractor, field.scale.kernel_size}});
    const WindowView window =
        window_of(options.views[0], kSide / kPixelsPerMm, 0, bounds_of(mesh).center());
    const auto paint = [&](bool may_wait) {
        return painter.paint(window, options, {Ink()}, may_wait);
    };
    const PaintedView first = paint(false), second = paint(true), third = paint(false);
    EXPECT_FALSE(first.is_final);
    EXPECT_GT(share_in(image_of(second), image_of(first)), 0.8);
    EXPECT_TRUE(second.is_final);
    EXPECT_TRUE(third.is_final);
    EXPECT_EQ(third.inks, second.inks);
    ViewPainter other({{mesh}});
    EXPECT_EQ(painted(other, window, options).inks, second.inks);
}

TEST(ViewPainter, RefusesAnEyeInsideTheSurface) {
    const laplacian_lines::TriangleMesh mesh = sheet_helpers::cube_of100();
    SheetOptions options = plain("front");
    options.views[0].eye = Eigen::Vector3d(0, 0, 0);
    ViewPainter painter({{mesh}});
    EXPECT_THROW(painted(painter, window_of(options.views[0], 1, 1), options),
                 laplacian_lines::Error);
}

}  // namespace
