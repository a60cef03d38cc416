// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// The layers of a document, in its order.
std::vector<const MeshModel*> layersOf(const MeshDocument& document);

/// Whether a filter works on the layers now: nobody else may look at them, although the progress
/// bar lets events in.
bool isBusy(const MeshDocument& document);

}  // namespace meshlab_host
