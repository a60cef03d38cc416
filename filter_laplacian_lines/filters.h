// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"
#include "meshlab_host/filter.h"

// What they say of themselves in dialogs is short: these have to fit small screens, and not all
// scroll.

/// MeshLab's side of laplacian_lines::precompute(): parameters in, per-vertex attributes out.
class ComputeFilter : public meshlab_host::Filter {
public:
    meshlab_host::FilterDescription description() const override;
    void listParameters(const MeshModel* mesh, RichParameterList& list) const override;
    std::vector<meshlab_host::ParameterDescription> describeParameters() const override;
    void run(const meshlab_host::FilterRun& run) const override;
};

/// The lines of a mesh from one view, as a layer of polylines.
class PolylineFilter : public meshlab_host::Filter {
public:
    meshlab_host::FilterDescription description() const override;
    void listParameters(const MeshModel* mesh, RichParameterList& list) const override;
    std::vector<meshlab_host::ParameterDescription> describeParameters() const override;
    void run(const meshlab_host::FilterRun& run) const override;
};

/// "12 Laplacian lines, 1 ridge": how many there are of each kind, without those of which there are
/// none.
QString kindsInWords(const laplacian_lines::LineSet& lines);

/// MeshLab's side of line_drawing: a measured drawing of a layer as it stands in the world, in a
/// file.
class DrawingFilter : public meshlab_host::Filter {
public:
    meshlab_host::FilterDescription description() const override;
    void listParameters(const MeshModel* mesh, RichParameterList& list) const override;
    void prepareDialog(const MeshDocument& document) const override;
    std::vector<meshlab_host::ParameterDescription> describeParameters() const override;
    void run(const meshlab_host::FilterRun& run) const override;
};
