// SPDX-License-Identifier: GPL-3.0-or-later
#include "printed_views.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "event_loop.h"
#include "prepared_lines.h"
#include "wavy_sheet.h"

namespace {

constexpr double kPixelsPerMm = 6.4;

class PrintedViewsTest : public testing::Test {
protected:
    PrintedViewsTest() {
        make_sheet(mesh_, 100);
        scene_ = scene_of({Eigen::Matrix4d::Identity()});
    }

    /// The sheet, as often as there are transformations.
    std::shared_ptr<PrintedScene> scene_of(const std::vector<Eigen::Matrix4d>& transforms) const {
        const PreparedLinesPointer lines =
            prepare_lines(mesh_, "sheet", meshlab_host::field_source(mesh_), [](const QString&) {});
        std::vector<LayerInScene> layers;
        for (const Eigen::Matrix4d& transform : transforms)
            layers.push_back({lines->printable, transform});
        return std::make_shared<PrintedScene>(layers);
    }

    /// From the front, turned by some degrees.
    PrintedView turned(double degrees) const { return turned(degrees, scene_); }
    static PrintedView turned(double degrees, const std::shared_ptr<PrintedScene>& scene) {
        Eigen::Affine3d to_eye(
            Eigen::AngleAxisd(degrees * std::acos(-1) / 180, Eigen::Vector3d::UnitY()));
        to_eye.translate(Eigen::Vector3d(-0.5, -0.5, 0));
        const Eigen::Matrix4d projection = Eigen::Vector4d(1.5, 1.5, -0.1, 1).asDiagonal();
        PrintedView view{scene, to_eye.matrix() * scene->to_world(), projection, {}, {}};
        view.window = *window_of(view.to_eye, projection, {400, 400}, kPixelsPerMm);
        return view;
    }
    Print request(const PrintedView& view, bool waits = false) {
        return prints_->request(this, &widget_, view, waits);
    }
    /// Processes events until the view is printed.
    line_renderer::InkPicturePointer wait_for(const PrintedView& view) {
        QElapsedTimer clock;
        clock.start();
        while (!request(view).is_final && clock.elapsed() < 60000)
            wait(5);
        return request(view).picture;
    }
    static int ink_of(const std::vector<std::uint8_t>& grays) {
        return int(std::count_if(grays.begin(), grays.end(), [](int gray) { return gray < 128; }));
    }
    static int inked(const line_renderer::InkPicturePointer& picture) {
        return ink_of(picture->inks.at(0));
    }

    CMeshO mesh_;
    std::shared_ptr<PrintedScene> scene_;
    CountingWidget widget_;
    std::unique_ptr<PrintedViews> prints_ = std::make_unique<PrintedViews>();
};

TEST_F(PrintedViewsTest, AreThereAtOnceForThoseWhoWait) {
    const Print print = request(turned(20), true);
    ASSERT_TRUE(print.picture);
    EXPECT_EQ(print.picture->size, Eigen::Vector2i(400, 400));
    EXPECT_GT(inked(print.picture), 400);
    EXPECT_EQ(request(turned(20)).picture, print.picture) << "once";
}

TEST_F(PrintedViewsTest, ComeOnceTheViewIsAtRestAndHaveItRedrawn) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 400) {  // as a user turns it
        EXPECT_FALSE(request(turned(double(clock.elapsed()))).picture);
        wait(20);
    }
    const int before = widget_.redraws();
    const auto picture = wait_for(turned(30));
    ASSERT_TRUE(picture);
    wait(50);
    EXPECT_GT(widget_.redraws(), before);
    prints_ = std::make_unique<PrintedViews>();
    EXPECT_EQ(request(turned(30), true).picture->inks, picture->inks);
}

TEST_F(PrintedViewsTest, StayForASnapshotOfOneTile) {
    PrintedView view = turned(20);
    const Print print = request(view, true);
    view.projection(0, 0) = std::nextafterf(1.5f, 2);
    EXPECT_EQ(request(view).picture, print.picture);
    view.projection(0, 0) *= 1.001;
    EXPECT_FALSE(request(view).picture);
}

TEST_F(PrintedViewsTest, AreGivenUpWhenTheViewMoves) {
    ASSERT_TRUE(wait_for(turned(30)));
    EXPECT_FALSE(request(turned(31)).picture);
    EXPECT_TRUE(wait_for(turned(31)));
    PrintedView other = turned(31);
    other.chosen.style.detail = 70;
    EXPECT_FALSE(request(other).picture);
    prints_->forget(this);
    wait(400);
    EXPECT_FALSE(request(other).picture);
    prints_.reset();  // while one is due
}

TEST_F(PrintedViewsTest, GoOnWithAViewWhenAnotherHasWaited) {
    const auto request_other = [&] {
        return prints_->request(&mesh_, &widget_, turned(40), false);
    };
    EXPECT_FALSE(request(turned(20)).picture);
    EXPECT_FALSE(request_other().picture);
    QElapsedTimer clock;
    for (clock.start(); clock.elapsed() < 155;)  // until one of them has begun
        wait(1);
    EXPECT_TRUE(request(turned(20), true).picture);
    for (clock.start(); !request_other().picture && clock.elapsed() < 20000;)
        wait(5);
    EXPECT_TRUE(request_other().picture);
}

TEST_F(PrintedViewsTest, SayOnceWhatTheyLack) {
    PrintedView inside = turned(0);
    inside.window.frame.eye = Eigen::Vector3d(0.5, 0.5, -1);  // before which there is nothing
    EXPECT_FALSE(request(inside, true).missing_reason.isEmpty());
    EXPECT_TRUE(request(inside, true).missing_reason.isEmpty());
    inside.chosen.style.detail = 70;
    EXPECT_TRUE(request(inside, true).missing_reason.isEmpty()) << "the same as last time";
    request(turned(20), true);
    const int before = widget_.redraws();
    EXPECT_FALSE(request(inside).picture);
    wait(1000);
    EXPECT_GT(widget_.redraws(), before) << "so that it can be told";
    EXPECT_FALSE(request(inside).missing_reason.isEmpty());
}

TEST_F(PrintedViewsTest, AreOfLayersHoweverTheyStand) {
    mesh_.Clear();
    make_sheet(mesh_, 330);  // so fine that it is not refined before it is stretched
    const Eigen::Matrix4d mirrored = Eigen::Vector4d(-2, 1, 1, 1).asDiagonal();
    const auto placed = request(turned(20, scene_of({mirrored})), true).picture;
    for (auto& vertex : mesh_.vert)
        vertex.P().X() *= -2;
    for (auto& face : mesh_.face)
        std::swap(face.V(1), face.V(2));
    const auto frozen = request(turned(20, scene_of({Eigen::Matrix4d::Identity()})), true).picture;
    EXPECT_GT(inked(frozen), 400);
    EXPECT_EQ(placed->inks, frozen->inks);
}

TEST_F(PrintedViewsTest, AreOfAllLayersWhichHideEachOther) {
    const Eigen::Matrix4d here = Eigen::Matrix4d::Identity();
    Eigen::Matrix4d before = here, beside = here;
    before(2, 3) = 0.5;
    beside(1, 3) = 1;
    const int one = inked(request(turned(0, scene_of({before})), true).picture),
              hidden = inked(request(turned(0, scene_of({here, before})), true).picture),
              two = inked(request(turned(0, scene_of({here, beside})), true).picture);
    EXPECT_GT(one, 400);
    EXPECT_NEAR(hidden, one, 0.02 * one);
    EXPECT_GT(two, 1.1 * one) << "as far as the window shows it";
}

TEST_F(PrintedViewsTest, HaveAnInkForEachColor) {
    PrintedView view = turned(60);
    const int all = inked(request(view, true).picture);
    auto& appearance = view.chosen.appearance;
    appearance.looks.fill({Qt::black});
    appearance.looks[std::size_t(laplacian_lines::LineKind::Border)].color = Qt::blue;
    appearance.hidden = line_renderer::HiddenLines::Faint;
    const auto inks = request(view, true).picture->inks;
    ASSERT_EQ(inks.size(), inks_of(view.chosen).size());
    ASSERT_EQ(inks.size(), 3u);
    const int hidden = ink_of(inks[0]), blue = ink_of(inks[1]), black = ink_of(inks[2]);
    EXPECT_GT(std::min({hidden, blue, black}), 20) << hidden << ' ' << blue << ' ' << black;
    EXPECT_NEAR(blue + black, all, 0.1 * all);
    view.chosen.appearance.looks[std::size_t(laplacian_lines::LineKind::Border)].color = Qt::red;
    EXPECT_TRUE(request(view).is_final) << "the same in another color";
}

TEST(WindowOf, IsNoneWhereLengthsDependOnTheDirection) {
    const Eigen::Matrix4d one = Eigen::Matrix4d::Identity();
    const auto of = [&](const Eigen::Vector3d& factors) {
        const Eigen::Matrix4d to_eye = Eigen::Affine3d(Eigen::Scaling(factors)).matrix();
        return window_of(to_eye, one, {10, 10}, 1).has_value();
    };
    EXPECT_TRUE(of({2, 2, 2}));
    EXPECT_FALSE(of({2, 1, 2}));
    EXPECT_FALSE(of({-1, 1, 1}));
}

}  // namespace
