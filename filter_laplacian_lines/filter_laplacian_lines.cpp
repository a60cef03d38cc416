// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters.h"

meshlab_host::FilterList makeFilters() {
    return {computeFilter(), polylineFilter(), drawingFilter()};
}

class FilterLaplacianLines : public meshlab_host::FilterPluginBase {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_FILTER_IID)
    Q_INTERFACES(MESHLAB_HOST_FILTER_INTERFACE)

public:
    FilterLaplacianLines() : FilterPluginBase("FilterLaplacianLines", makeFilters()) {}
};

MESHLAB_PLUGIN_NAME_EXPORTER(FilterLaplacianLines)

#include "filter_laplacian_lines.moc"
