// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "laplacian_lines/line_mixture.h"

/// The choice "Settings" of filters: what the filter itself says, what the decoration has drawn,
/// and then a mixture of kinds of lines each. Its numbers are what scripts hold.

/// Those of the filter, and then the mixtures.
std::vector<const char*> settingsNames(std::vector<const char*> own);

/// Null for the first two.
const laplacian_lines::LineMixture* mixtureAt(int settings);
