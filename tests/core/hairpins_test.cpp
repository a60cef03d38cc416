// SPDX-License-Identifier: GPL-3.0-or-later
#include "redraw/hairpins.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace laplacian_lines;

namespace {

constexpr float kKernel = 0.01f, kStep = kKernel / 10;
constexpr std::uint32_t kPoints = 401, kMiddle = 200;

/// A line with one corner, which turns it by an angle.
class Bent {
public:
    explicit Bent(double degrees) {
        const double angle = degrees / 57.29577951308232;
        for (std::uint32_t i = 0; i < kPoints; ++i) {
            const float along = kStep * (float(i) - float(kMiddle));
            x_[i] = i > kMiddle ? along * float(std::cos(angle)) : along;
            y_[i] = i > kMiddle ? along * float(std::sin(angle)) : 0;
            starts_[i] = opacities_[i] = 1;
        }
        columns_.x = x_;
        columns_.y = y_;
        columns_.z = z_;
    }
    /// Makes a part of it unclear.
    void weaken(std::uint32_t begin, std::uint32_t end) {
        std::fill(starts_ + begin, starts_ + end, 0.f);
    }
    bool find() { return hairpins_.find(columns_, kPoints, kKernel); }
    const std::vector<Hairpins::Range>& fade() {
        hairpins_.fade(starts_, opacities_);
        return hairpins_.ranges();
    }
    float opacity(std::uint32_t i) const { return opacities_[i]; }

private:
    float x_[kPoints], y_[kPoints], z_[kPoints] = {}, starts_[kPoints], opacities_[kPoints];
    LineColumns columns_{};
    Hairpins hairpins_;
};

TEST(Hairpins, AreTurnsOfMoreThanARightAngle) {
    for (const double degrees : {0., 30., 60., 88.})
        EXPECT_FALSE(Bent(degrees).find()) << degrees;
    for (const double degrees : {93., 110., 150., 180.})
        EXPECT_TRUE(Bent(degrees).find()) << degrees;
}

TEST(Hairpins, EvenBowsAreNone) {
    float x[kPoints], y[kPoints], z[kPoints] = {};
    for (std::uint32_t i = 0; i < kPoints; ++i) {  // twice around, radius √h
        x[i] = kKernel * float(std::cos(i * 0.03));
        y[i] = kKernel * float(std::sin(i * 0.03));
    }
    LineColumns columns{};
    columns.x = x;
    columns.y = y;
    columns.z = z;
    EXPECT_FALSE(Hairpins().find(columns, kPoints, kKernel));
}

TEST(Hairpins, CutALineThatIsClearOnBothSidesInTwo) {
    Bent line(170);
    ASSERT_TRUE(line.find());
    const auto ranges = line.fade();
    ASSERT_EQ(ranges.size(), 2u);
    EXPECT_NEAR(ranges[0].end, kMiddle, 4);
    EXPECT_NEAR(ranges[1].begin, kMiddle, 4);
    EXPECT_EQ(line.opacity(100), 1);
    EXPECT_EQ(line.opacity(300), 1);
    EXPECT_EQ(line.opacity(kMiddle), 0);
}

TEST(Hairpins, HideWhatGoesOnWithoutStartingBeyondThem) {
    for (const bool first : {false, true}) {
        Bent line(170);
        line.weaken(first ? 0 : kMiddle - 10, first ? kMiddle + 10 : kPoints);
        ASSERT_TRUE(line.find());
        line.fade();
        EXPECT_EQ(line.opacity(100), first ? 0 : 1);
        EXPECT_EQ(line.opacity(300), first ? 1 : 0);
    }
}

/// Small changes of the angle change little.
TEST(Hairpins, ComeEvenly) {
    float before = 1;
    for (double degrees = 80; degrees < 130; degrees += 0.5) {
        Bent line(degrees);
        line.weaken(kMiddle, kPoints);
        if (line.find()) line.fade();
        EXPECT_NEAR(line.opacity(300), before, 0.1) << degrees;
        before = line.opacity(300);
    }
    EXPECT_EQ(before, 0);
}

}  // namespace
