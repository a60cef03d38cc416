// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/filter.h"

/// The lines of a mesh from one view, as a layer of polylines.
class PolylineFilter : public meshlab_host::Filter {
public:
    meshlab_host::FilterDescription description() const override;
    void listParameters(const MeshModel* mesh, RichParameterList& list) const override;
    void run(const meshlab_host::FilterRun& run) const override;
};
