// SPDX-License-Identifier: GPL-3.0-or-later
#include "extraction_times.h"

#include "laplacian_lines/field_columns.h"
#include "redraws.h"

namespace benchmarks {

using namespace laplacian_lines;

const Section kExtraction{"extraction_ms", "A redraw, ms"};
const Section kRatios{"ratios", "Ratios"};
const Section kBuilding{"building_s", "Once a mesh, s"};
const Section kMemory{"memory", "Memory, bytes a vertex"};

namespace {

const Section kMedians{"extraction_median_ms", nullptr};
const Section kCounts{"counts", nullptr};

/// Time a divided by time b.
struct Ratio {
    const char *key, *text, *a, *b;
};
constexpr Ratio kAllRatios[] = {
    {"lines_to_contours", "Laplacian lines and contours : plain contours", "lines",
     "plain_contours"},
    {"lines_to_suggestive", "... : suggestive contours", "lines", "suggestive_contours"},
    {"lines_to_traced", "... : plain Laplacian lines, traced", "lines", "plain_laplacian_traced"},
    {"lines_to_reading", "... : reading the plain mesh", "lines", "read_plain_mesh"},
    {"lines_to_reading_extractor", "... : reading what the extractor holds", "lines",
     "read_extractor"},
    {"one_to_two_threads", "one thread : two threads", "lines", "lines_two_threads"},
    {"avx2_to_avx512", "AVX2 : AVX-512", "lines_avx2", "lines"},
    {"baseline_to_best", "baseline x86-64 : the best instruction set", "lines_baseline", "lines"},
    {"suggestive_to_contours", "suggestive contours : plain contours", "suggestive_contours",
     "plain_contours"},
    {"traced_to_contours", "plain Laplacian lines, traced : plain contours",
     "plain_laplacian_traced", "plain_contours"},
};

void add_ratios(MeshFigures& figures) {
    for (const Ratio& r : kAllRatios) {
        const double a = figures.value(kExtraction, r.a), b = figures.value(kExtraction, r.b);
        if (a > 0 && b > 0) figures.add(kRatios, r.key, r.text, a / b);
    }
}

void append(std::vector<Contender>& all, std::vector<Contender> more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void add_extraction(const TriangleMesh& mesh, const Field& field, Turns turns,
                    MeshFigures& figures) {
    Redraws redraws(mesh, field);
    redraws.check_zeros();
    figures.add(kBuilding, "extractor", "building the extractor, all threads",
                redraws.extractor_seconds());
    figures.add(kBuilding, "curvature_derivatives",
                "curvatures and their derivatives for suggestive contours, one thread",
                redraws.curvature_seconds());
    figures.add(kMemory, "extractor", "extractor",
                double(redraws.extractor().memory()) / double(mesh.positions.size()));
    std::size_t field_bytes = 0;
    for (const FieldColumn& column : present_columns(field))
        field_bytes += std::size_t(column.floats) * sizeof(float);
    figures.add(kMemory, "field", "field", double(field_bytes));
    std::vector<Contender> contenders = redraws.fast();
    append(contenders, redraws.plain());
    append(contenders, redraws.reading());
    for (const Contender& c : contenders)
        c.run(0);  // allocates, and finds what is found once
    turns.cases = redraws.view_count();
    figures.add(kCounts, "rounds", "rounds", take_turns(contenders, turns));
    for (const Contender& c : contenders) {
        figures.add(kExtraction, c.key, c.text, 1e3 * c.best());
        figures.add(kMedians, c.key, c.text, 1e3 * c.median());
    }
    add_ratios(figures);
    const LineSet& lines = redraws.lines(0);
    figures.add(kCounts, "lines", "lines at the first eye", double(lines.lines.size()));
    figures.add(kCounts, "segments", "segments at the first eye", double(lines.segment_count()));
}

}  // namespace benchmarks
