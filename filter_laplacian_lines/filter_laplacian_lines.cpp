// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_laplacian_lines.h"

#include "filter_list.h"

FilterLaplacianLines::FilterLaplacianLines()
    : FilterPluginBase("FilterLaplacianLines", makeFilters()) {}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterLaplacianLines)
