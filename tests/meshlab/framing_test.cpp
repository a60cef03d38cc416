// SPDX-License-Identifier: GPL-3.0-or-later
// ./run --picture's camera: all points are in the window, centred, as large as possible.
#include "framing.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using driver::Window;
using Points = std::vector<Eigen::Vector3d>;

Points randomPoints(unsigned seed, const Eigen::Vector3d& sizes) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Points points(500);
    for (Eigen::Vector3d& p : points)
        p = sizes.cwiseProduct(Eigen::Vector3d(normal(random), normal(random), normal(random)));
    return points;
}

/// In the picture, by tangents in perspective.
Eigen::AlignedBox2d pictureFrom(const Eigen::Vector3d& eye, const Points& points) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector3d& p : points)
        box.extend(Eigen::Vector2d((p - eye).head<2>() / (eye.z() - p.z())));
    return box;
}

constexpr double exact = 1e-9;

void expectFilled(const Eigen::AlignedBox2d& box, const Window& window) {
    EXPECT_LT(box.center().norm(), exact);
    const double x = box.max().x() / window.half_width, y = box.max().y() / window.half_height;
    EXPECT_NEAR(std::max(x, y), 1, exact);
}

const Eigen::Vector3d wide(3, 1, 1), high(0.2, 2, 0.5), deep(1, 0.7, 2);

TEST(Framing, FillsAWindowInPerspective) {
    unsigned seed = 0;
    for (const Eigen::Vector3d& sizes : {wide, high, deep})
        for (const Window& window : {Window{0.5, 0.5}, Window{0.7, 0.5}, Window{0.2, 0.6}}) {
            const Points points = randomPoints(++seed, sizes);
            const double distance = driver::leastDistance(points, window, 0.01);
            expectFilled(pictureFrom(driver::centredEye(points, distance), points), window);
        }
}

TEST(Framing, KeepsPointsAwayFromTheEye) {
    const Points points = randomPoints(1, {0.01, 0.01, 5});
    const double nearest = 0.1, distance = driver::leastDistance(points, {0.5, 0.5}, nearest);
    double front = 0;
    for (const Eigen::Vector3d& p : points)
        front = std::max(front, p.z());
    EXPECT_NEAR(distance - front, nearest * distance, exact);
}

TEST(Framing, IsInTheMiddleFromFartherAwayToo) {
    const Points points = randomPoints(2, wide);
    EXPECT_LT(pictureFrom(driver::centredEye(points, 40), points).center().norm(), exact);
}

TEST(Framing, FillsAWindowWithParallelRays) {
    const Window window{0.7, 0.5};
    for (const Eigen::Vector3d& sizes : {wide, high, deep}) {
        const Points points = randomPoints(3, sizes);
        const driver::ParallelFrame frame = driver::parallelFrame(points, window);
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector3d& p : points)
            box.extend(Eigen::Vector2d((p.head<2>() - frame.middle) / frame.scale));
        expectFilled(box, window);
    }
}

}  // namespace
