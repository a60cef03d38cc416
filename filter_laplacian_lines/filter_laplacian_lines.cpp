// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_laplacian_lines.h"

#include "filters.h"

meshlab_host::FilterList makeFilters() {
    return {computeFilter(), polylineFilter(), drawingFilter()};
}

FilterLaplacianLines::FilterLaplacianLines()
    : FilterPluginBase("FilterLaplacianLines", makeFilters()) {}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterLaplacianLines)
