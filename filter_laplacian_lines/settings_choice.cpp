// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings_choice.h"

namespace {

constexpr int first_mixture = 2;

}  // namespace

std::vector<const char*> settingsNames(std::vector<const char*> own) {
    for (const laplacian_lines::LineMixture& mixture : laplacian_lines::line_mixtures)
        own.push_back(mixture.label);
    return own;
}

const laplacian_lines::LineMixture* mixtureAt(int settings) {
    if (settings < first_mixture) return nullptr;
    return &laplacian_lines::line_mixtures.at(std::size_t(settings - first_mixture));
}
