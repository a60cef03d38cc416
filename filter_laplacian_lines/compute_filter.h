// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/filter.h"

/// MeshLab's side of laplacian_lines::precompute(): parameters in, per-vertex attributes out.
class ComputeFilter : public meshlab_host::Filter {
public:
    meshlab_host::FilterDescription description() const override;
    void listParameters(const MeshModel* mesh, RichParameterList& list) const override;
    std::vector<meshlab_host::ParameterDescription> describeParameters() const override;
    void run(const meshlab_host::FilterRun& run) const override;
};
