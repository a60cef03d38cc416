// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_style.h"
#include "line_renderer.h"
#include "meshlab_host/meshlab_api.h"
#include "surface_renderer.h"

/// What the user chose in MeshLab's decoration parameters, which are the same for all views.
struct DecorationParameters {
    laplacian_lines::LineStyle style;
    LineAppearance appearance;
    SurfaceAppearance surface;
    bool show_statistics = false;
};

/// Adds all parameters with their defaults. The names are unique among MeshLab's plugins.
void listDecorationParameters(RichParameterList& list);

/// @throws laplacian_lines::Error(InvalidOption) that names a threshold which is out of range.
DecorationParameters readDecorationParameters(const RichParameterList& list);
