// SPDX-License-Identifier: GPL-3.0-or-later
#include "published_figures.h"

#include "kind_styles.h"

namespace benchmarks {

using laplacian_lines::LineKind;

const Section kRedraw{"redraw_ms", "A redraw, ms, one thread"};
const Section kToContours{"to_contours", "Times as long as contours alone"};

const char* const kPublishedNote =
    "paper: Zhang, He, Seah 2009, the least and the largest ratio of their table, drawing\n"
    "included. rtsc: Princeton's program as shipped, measured once beside this project on one\n"
    "thread; it traces nothing, and its suggestive contours are with contours.\n";

namespace {

struct Time {
    LineKind kind;
    double ms;
};

/// Of a program by which contours take so many ms.
MeshFigures of_program(const char* name, double contours, const std::vector<Time>& times) {
    MeshFigures figures{name};
    const auto add = [&](LineKind kind, double ms) {
        const NamedStyle row = only(kind);
        figures.add(kRedraw, row.key, row.text, ms);
        figures.add(kToContours, row.key, row.text, ms / contours);
    };
    add(LineKind::Contour, contours);
    for (const Time& time : times)
        add(time.kind, time.ms);
    return figures;
}

struct Ratio {
    LineKind kind;
    double value;
};

MeshFigures of_paper(const char* name, const std::vector<Ratio>& ratios) {
    MeshFigures figures{name};
    for (const Ratio& ratio : ratios) {
        const NamedStyle row = only(ratio.kind);
        figures.add(kToContours, row.key, row.text, ratio.value);
    }
    return figures;
}

}  // namespace

std::vector<MeshFigures> published_figures() {
    using Kind = LineKind;
    return {
        of_paper("paper, least", {{Kind::Contour, 1},
                                  {Kind::Laplacian, 1.28},
                                  {Kind::SuggestiveContour, 1.7},
                                  {Kind::ApparentRidge, 7.5},
                                  {Kind::PhoticExtremum, 7.5}}),
        of_paper("paper, most", {{Kind::Contour, 1},
                                 {Kind::Laplacian, 1.77},
                                 {Kind::SuggestiveContour, 1.9},
                                 {Kind::ApparentRidge, 13},
                                 {Kind::PhoticExtremum, 13}}),
        of_program("rtsc, bunny", 0.34,
                   {{Kind::SuggestiveContour, 0.91}, {Kind::ApparentRidge, 4.1}}),
        of_program("rtsc, igea", 1.25,
                   {{Kind::SuggestiveContour, 3.5}, {Kind::ApparentRidge, 14.7}}),
        of_program("rtsc, dragon", 6.1,
                   {{Kind::SuggestiveContour, 18.6}, {Kind::ApparentRidge, 78}}),
    };
}

}  // namespace benchmarks
