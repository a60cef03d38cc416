// SPDX-License-Identifier: GPL-3.0-or-later
#include "kind_styles.h"

#include "laplacian_lines/line_mixture.h"

namespace benchmarks {

using namespace laplacian_lines;

NamedStyle only(LineKind kind) {
    LineStyle style;
    style.shows = only_kinds({kind});
    return {describe(kind).key, describe(kind).many, style};
}

std::vector<NamedStyle> kind_styles() {
    std::vector<NamedStyle> styles;
    for (const LineKind kind :
         {LineKind::Contour, LineKind::Laplacian, LineKind::SuggestiveContour,
          LineKind::SuggestiveHighlight, LineKind::ApparentRidge, LineKind::PhoticExtremum,
          LineKind::Ridge, LineKind::Valley, LineKind::DemarcatingCurve})
        styles.push_back(only(kind));
    styles.push_back({"default", "the default style", LineStyle()});
    LineStyle all;
    all.shows = all_kinds();
    styles.push_back({"all", "all kinds at once", all});
    return styles;
}

}  // namespace benchmarks
