// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/filter.h"

/// In the order of the plugin's actions.
meshlab_host::FilterList makeFilters();

class FilterLaplacianLines : public meshlab_host::FilterPluginBase {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_FILTER_IID)
    Q_INTERFACES(MESHLAB_HOST_FILTER_INTERFACE)

public:
    FilterLaplacianLines();
};
