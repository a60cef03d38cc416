// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/filter.h"

// Descriptions in dialogs are short: these have to fit small screens, and not all scroll.

/// laplacian_lines::precompute(): parameters in, per-vertex attributes out.
class ComputeFilter : public meshlab_host::Filter {
public:
    meshlab_host::FilterDescription description() const override;
    void listParameters(const MeshModel* mesh, RichParameterList& list) const override;
    void run(const meshlab_host::FilterRun& run) const override;
};

/// The lines of a mesh from one view, as a layer of polylines.
class PolylineFilter : public meshlab_host::Filter {
public:
    meshlab_host::FilterDescription description() const override;
    void listParameters(const MeshModel* mesh, RichParameterList& list) const override;
    void run(const meshlab_host::FilterRun& run) const override;
};

/// A measured drawing, as a file, of a layer as it stands in the world.
class DrawingFilter : public meshlab_host::Filter {
public:
    meshlab_host::FilterDescription description() const override;
    void listParameters(const MeshModel* mesh, RichParameterList& list) const override;
    void run(const meshlab_host::FilterRun& run) const override;
};
