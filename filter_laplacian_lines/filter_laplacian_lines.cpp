// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_laplacian_lines.h"

#include "filters.h"

meshlab_host::FilterList makeFilters() {
    meshlab_host::FilterList result;
    result.push_back(std::make_unique<ComputeFilter>());
    result.push_back(std::make_unique<PolylineFilter>());
    result.push_back(std::make_unique<DrawingFilter>());
    return result;
}

FilterLaplacianLines::FilterLaplacianLines()
    : FilterPluginBase("FilterLaplacianLines", makeFilters()) {}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterLaplacianLines)
