// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshlab_host/filter_plugin_base.h"

/// New ones of all filters of the plugin, in the order of its actions.
meshlab_host::FilterList makeFilters();
