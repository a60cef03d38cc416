// SPDX-License-Identifier: GPL-3.0-or-later
#include "test_paths.h"

std::filesystem::path test_paths::repository() {
    return REPOSITORY;
}
