// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/camera.h"

namespace meshlab_host {

/// How much larger than the view a picture is that MeshLab composes of tiles. A tile fills the view
/// with part of the camera's frustum, so lengths in pixels have to grow with the picture.
class SnapshotTiles {
public:
    /// Tiles in a row of the picture, 1 if this is no tile. Call it at every redraw: earlier tiles
    /// identify those in the middle.
    double scale(const CameraMatrices& camera);
    /// The camera at the picture's middle: the same for all tiles, to the bit. Meaningless without
    /// tiles.
    const CameraMatrices& camera() const { return middle_; }

private:
    CameraMatrices camera_;  ///< of the last snapshot's first tile
    CameraMatrices middle_;
    double scale_ = 1;
};

}  // namespace meshlab_host
