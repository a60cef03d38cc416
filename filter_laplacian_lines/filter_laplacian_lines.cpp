// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_laplacian_lines.h"

#include "compute_filter.h"
#include "drawing_filter.h"
#include "polyline_filter.h"

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
