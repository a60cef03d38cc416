// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/camera.h"

namespace meshlab_host {

/// Tells how much larger than the view a picture is that MeshLab puts together from tiles. A tile
/// fills the view, but shows only a part of the camera's frustum, so lengths in pixels have to grow
/// as the picture does.
class SnapshotTiles {
public:
    /// Number of tiles in a row of the picture that is being drawn; 1 if it is not a tile. To be
    /// called at every redraw: a tile in the middle is known by those before it.
    double scale(const CameraMatrices& camera);
    /// The camera of the tiles of that picture, moved to its middle: the same for all of them, to
    /// the bit. Means nothing if it is not a tile.
    const CameraMatrices& camera() const { return middle_; }

private:
    CameraMatrices camera_;  ///< of the last snapshot's first tile
    CameraMatrices middle_;
    double scale_ = 1;
};

}  // namespace meshlab_host
