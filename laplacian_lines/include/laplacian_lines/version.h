// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

/// Of all that is built with this core, as "0.3.0". docs/changelog.md says what has changed when.
const char* version();

}  // namespace laplacian_lines
