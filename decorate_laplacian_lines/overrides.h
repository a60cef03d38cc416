// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "decoration_parameters.h"

/// A parameter that stands for others, which have no effect unless it leaves them alone.
struct Override {
    const char* key;
    const char* label;
    const char* value;     ///< of a choice, that leaves the others alone
    const char* sentence;  ///< why the others are off
};

/// What may override the parameter with this key: the drawing style or the choice of lines; null
/// for those that always count.
const Override* overrideOf(const std::string& key);

/// Whether it does, with what is chosen.
bool isOverridden(const std::string& key, const DecorationParameters& chosen);
