// SPDX-License-Identifier: GPL-3.0-or-later
// The plugin, with what each version of MeshLab asks of one.
#include "filters.h"

meshlab_host::FilterList make_filters() {
    return {compute_filter(), polyline_filter(), drawing_filter()};
}

class FilterLaplacianLines : public meshlab_host::FilterPluginBase {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESHLAB_HOST_FILTER_IID)
    Q_INTERFACES(MESHLAB_HOST_FILTER_INTERFACE)

public:
    FilterLaplacianLines() : FilterPluginBase("FilterLaplacianLines", make_filters()) {}
};

MESHLAB_PLUGIN_NAME_EXPORTER(FilterLaplacianLines)

#include "filter_laplacian_lines.moc"
