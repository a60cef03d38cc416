// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/line_set.h"
#include "meshlab_host/filter.h"

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
