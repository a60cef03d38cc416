// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/filter_plugin_base.h"

/// MeshLab's side of laplacian_lines::precompute(): parameters in, per-vertex attributes out.
class FilterLaplacianLines : public meshlab_host::FilterPluginBase {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_FILTER_IID)
    Q_INTERFACES(MESHLAB_HOST_FILTER_INTERFACE)

public:
    FilterLaplacianLines();

protected:
    void listParameters(const MeshModel* mesh, RichParameterList& list) const override;
    void run(MeshDocument& document, const RichParameterList& parameters,
             vcg::CallBackPos* progress) override;
};
