// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <cstdint>
#include <memory>
#include <vector>

namespace line_renderer {

template <class Object>
class PerShareGroup;

/// A picture in grays, a byte a pixel, rows from the top: what is black in it is inked. Shared, so
/// that a picture is known by its address as long as anything shows it.
struct InkPicture {
    Eigen::Vector2i size;
    std::vector<std::uint8_t> grays;
};
using InkPicturePointer = std::shared_ptr<const InkPicture>;

/// Where a picture lies in the viewport, in its coordinates of -1..1: a tile of a large picture
/// shows a part of it.
struct PicturePlace {
    double scale = 1;
    Eigen::Vector2d shift = {0, 0};
};

/// Lays pictures over the view. Keeps the last one in OpenGL's memory, and OpenGL's state. GUI
/// thread only.
class PictureRenderer {
public:
    PictureRenderer();
    ~PictureRenderer();

    /// Of pictures that the current context can show, pixels.
    static int largestSide();

    /// @throws std::runtime_error if OpenGL cannot do it
    void paint(const InkPicturePointer& picture, const QColor& ink, const PicturePlace& place);

private:
    struct Objects;
    std::unique_ptr<PerShareGroup<Objects>> objects_;
};

}  // namespace line_renderer
