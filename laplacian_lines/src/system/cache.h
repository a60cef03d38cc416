// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

/// Bytes that caches fetch and keep together.
constexpr unsigned kCacheUnit = 64;

}  // namespace laplacian_lines
