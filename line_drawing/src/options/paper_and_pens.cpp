// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/paper_and_pens.h"

#include <algorithm>
#include <array>

#include "line_drawing/words.h"

namespace line_drawing {
namespace {

struct Paper {
    const char* name;
    double width, height;  // mm, portrait
};
constexpr Paper kPapers[] = {{"a5", 148, 210}, {"a4", 210, 297}, {"a3", 297, 420},
                             {"a2", 420, 594}, {"a1", 594, 841}, {"a0", 841, 1189}};

/// Pens are in steps of √2, as paper is.
constexpr std::array<double, 10> kPenSeries = {0.1, 0.13, 0.18, 0.25, 0.35, 0.5, 0.7, 1, 1.4, 2};
// mm on paper: drawings smaller than these get pens one or two steps finer, in proportion.
constexpr double kFullSize = 40, kSmallSize = 28;

}  // namespace

std::optional<Eigen::Vector2d> paper_size(const std::string& name) {
    if (lower(name) == "fit") return {};
    for (const Paper& paper : kPapers)
        if (lower(name) == paper.name) return Eigen::Vector2d(paper.width, paper.height);
    refuse("There is no paper \"" + name +
           "\". Papers are a5, a4, a3, a2, a1, a0, or fit: as large as the drawing.");
}

std::vector<const char*> paper_names() {
    std::vector<const char*> names;
    for (const Paper& paper : kPapers)
        names.push_back(paper.name);
    names.push_back("fit");
    return names;
}

std::vector<double> usual_scales() {
    std::vector<double> scales;  // as on rulers: 4:1, but not 40:1; 1:25, but not 1:2.5
    for (const double tens : {1000., 100., 10., 1.})
        for (const double first : {5., 4., 2., 1.})
            if (first != 4. || tens == 1.) scales.push_back(first * tens);
    for (const double tens : {1., 10., 100., 1000., 10000.})
        for (const double first : {2., 2.5, 3., 4., 5., 10.})
            if (first != 2.5 || tens > 1) scales.push_back(1 / (first * tens));
    return scales;
}

Pens finer(Pens pens, std::ptrdiff_t steps) {
    for (double& pen : pens) {
        const auto place = std::lower_bound(kPenSeries.begin(), kPenSeries.end(), pen);
        if (place == kPenSeries.end()) continue;
        const std::ptrdiff_t at = place - kPenSeries.begin();
        pen = std::min(pen, kPenSeries[std::size_t(std::max<std::ptrdiff_t>(0, at - steps))]);
    }
    return pens;
}

Pens pens_for(double size, const Pens& pens) {
    return finer(pens, size >= kFullSize ? 0 : size >= kSmallSize ? 1 : 2);
}

}  // namespace line_drawing
