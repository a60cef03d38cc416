// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures over the view.
#include "line_renderer/picture_renderer.h"

#include "gl_test.h"

namespace {

using line_renderer::InkPicture;

constexpr int kWidth = 2 * Canvas::width, kHeight = 3 * Canvas::height;

class PictureTest : public GlTest {
protected:
    /// What the view shows from a corner on.
    QImage shown(const std::vector<QColor>& colors, const Eigen::Vector2i& corner) {
        pictures_.paint(picture_, colors, corner);
        return canvas_.picture();
    }
    /// Inks a pixel, from the upper left.
    void put(std::size_t ink, int x, int y) {
        picture_.inks[ink][std::size_t(y) * kWidth + std::size_t(x)] = 0;
    }

    InkPicture picture_ = {{kWidth, kHeight},
                           std::vector(2, std::vector<std::uint8_t>(kWidth* kHeight, 255))};
    line_renderer::PictureRenderer pictures_;
};

TEST_F(PictureTest, LaysInksOverEachOtherInTheirColors) {
    put(0, 3, 2);
    put(0, 5, 2);
    put(1, 5, 2);
    const QImage view = shown({Qt::blue, QColor(255, 0, 0, 128)}, {0, 0});
    EXPECT_EQ(color_at(view, 3, Canvas::height - 3), QColor(Qt::blue));
    EXPECT_NEAR(color_at(view, 5, Canvas::height - 3).redF(), 0.5, 0.01);
    EXPECT_NEAR(color_at(view, 5, Canvas::height - 3).blueF(), 0.5, 0.01);
    EXPECT_EQ(color_at(view, 4, Canvas::height - 3), QColor(Qt::white));
}

TEST_F(PictureTest, ShowsTheViewsPartOfALargePicture) {
    put(0, Canvas::width + 7, 2 * Canvas::height + 4);
    put(1, 1, 1);
    const QImage view = shown({Qt::black, Qt::red}, {Canvas::width, 2 * Canvas::height});
    EXPECT_EQ(color_at(view, 7, Canvas::height - 5), QColor(Qt::black));
    EXPECT_NEAR(ink_of(view), 1, 1e-9);
}

}  // namespace
