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

/// A picture in several inks. Each is a byte a pixel, rows from the top, ink where it is black.
struct InkPicture {
    Eigen::Vector2i size;
    std::vector<std::vector<std::uint8_t>> inks;
};
using InkPicturePointer = std::shared_ptr<const InkPicture>;

/// Draws pictures over the view. Keeps OpenGL's state. GUI thread only.
class PictureRenderer {
public:
    PictureRenderer();
    ~PictureRenderer();

    /// Fills the viewport with the part of the picture whose upper left pixel is `corner`; the
    /// picture has to hold all of that part. `colors`, with their alpha: of the inks, the last of
    /// which lies over the others. @throws std::runtime_error if OpenGL cannot do it
    void paint(const InkPicture& picture, const std::vector<QColor>& colors,
               const Eigen::Vector2i& corner);

private:
    struct Objects;
    std::unique_ptr<PerShareGroup<Objects>> objects_;
};

}  // namespace line_renderer
