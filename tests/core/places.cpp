// SPDX-License-Identifier: GPL-3.0-or-later
#include "places.h"

std::filesystem::path places::repository() {
    return REPOSITORY;
}
