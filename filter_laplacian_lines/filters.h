// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/filter.h"

// Descriptions in dialogs are short: these have to fit small screens, and not all scroll.

/// laplacian_lines::precompute(): parameters in, per-vertex attributes out.
meshlab_host::Filter compute_filter();

/// The lines of a mesh from one view, as a layer of polylines.
meshlab_host::Filter polyline_filter();

/// A measured drawing, as a file, of a layer or all visible ones, as they stand in the world.
meshlab_host::Filter drawing_filter();

/// "1 vertex", "12 vertices"
inline QString counted(std::size_t count, const char* one, const char* several) {
    return QString("%1 %2").arg(count).arg(count == 1 ? one : several);
}

/// All, in the order of the plugin's actions.
meshlab_host::FilterList make_filters();
