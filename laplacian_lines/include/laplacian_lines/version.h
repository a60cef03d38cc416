// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

/// Such as "0.3.0", see CHANGELOG.md.
const char* version();

}  // namespace laplacian_lines
