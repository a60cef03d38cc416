// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/filter_plugin_base.h"

/// New ones of all filters of the plugin, in the order of its actions.
meshlab_host::FilterList makeFilters();

/// What MeshLab loads: the filters of Laplacian lines.
class FilterLaplacianLines : public meshlab_host::FilterPluginBase {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_FILTER_IID)
    Q_INTERFACES(MESHLAB_HOST_FILTER_INTERFACE)

public:
    FilterLaplacianLines();
};
