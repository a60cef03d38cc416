// SPDX-License-Identifier: GPL-3.0-or-later
#include "laplacian_lines/version.h"

namespace laplacian_lines {

const char* version() {
    return LAPLACIAN_LINES_VERSION;
}

}  // namespace laplacian_lines
