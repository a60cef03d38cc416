// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/filter.h"

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
