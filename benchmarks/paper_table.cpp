// SPDX-License-Identifier: GPL-3.0-or-later
// paper_table [--seconds S] [--json FILE] MESH...
// The program behind ./bench --paper: the table of the paper, redraws of each kind of lines against
// contours alone, beside the figures that others have published or were measured with. Times are
// medians; those of one thread are processor time, which depends little on what else runs.
#include <omp.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <utility>

#include "kind_styles.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"
#include "orbit.h"
#include "published_figures.h"
#include "speed_report.h"
#include "turns.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;

const Section kSize{"size", "Size"};
const Section kFrames{"frames", "Frames a second, one thread"};
const Section kTwoThreads{"redraw_two_threads_ms", "A redraw, ms, two threads"};
const Section kThreads{"one_to_two_threads", "One thread : two threads"};
const Section kOnce{"once_s", "Once a mesh, s"};

struct Arguments {
    double seconds = 20;  ///< for the redraws of a mesh
    std::string json;
    std::vector<std::string> files;
};

Arguments parse(int argc, char** argv) {
    Arguments result;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool has_value = i + 1 < argc;
        if (argument == "--seconds" && has_value) {
            result.seconds = std::atof(argv[++i]);
        } else if (argument == "--json" && has_value) {
            result.json = argv[++i];
        } else if (argument[0] == '-') {
            throw std::invalid_argument("unknown option " + argument + ", or without its value");
        } else {
            result.files.push_back(argument);
        }
    }
    if (result.files.empty()) throw std::invalid_argument("no mesh is named");
    return result;
}

PrecomputeOptions field_options(bool derivatives) {
    PrecomputeOptions options;
    options.curvature_derivatives = derivatives;
    return options;
}

/// The field without C and with it, on one thread and on two.
void add_fields(const TriangleMesh& mesh, MeshFigures& figures) {
    std::vector<Contender> contenders;
    for (const int threads : {1, 2})
        for (const bool derivatives : {false, true})
            contenders.push_back({"", "",
                                  [&mesh, threads, derivatives](std::size_t) {
                                      omp_set_num_threads(threads);
                                      precompute(mesh, field_options(derivatives));
                                  },
                                  threads == 1});
    Turns turns;
    turns.most_rounds = 5;
    turns.budget = 8;
    take_turns(contenders, turns);
    const std::pair<const char*, const char*> rows[] = {
        {"field", "the field, one thread"},
        {"field_with_derivatives", "the field with C, one thread"},
        {"field_two_threads", "the field, two threads"},
        {"field_with_derivatives_two_threads", "the field with C, two threads"}};
    for (std::size_t i = 0; i < contenders.size(); ++i)
        figures.add(kOnce, rows[i].first, rows[i].second, contenders[i].median());
}

/// What is drawn of lines, from the eyes of orbit.h.
class Drawing {
public:
    Drawing(const TriangleMesh& mesh, const Field& field)
        : views_(orbit(mesh)), extractor_(mesh, field) {}

    std::size_t view_count() const { return views_.size(); }

    void redraw(std::size_t view, int threads, const LineStyle& style) {
        omp_set_num_threads(threads);
        extractor_.extract(views_[view], style, scratch_, lines_);
    }

private:
    const std::vector<View> views_;
    const LineExtractor extractor_;
    ExtractionScratch scratch_;
    LineSet lines_;
};

/// What does not depend on the view is found at the first redraw.
void add_finding(Drawing& drawing, MeshFigures& figures) {
    for (const LineKind kind : {LineKind::Ridge, LineKind::Valley, LineKind::DemarcatingCurve}) {
        const NamedStyle found = only(kind);
        figures.add(kOnce, found.key, "finding " + found.text + ", one thread",
                    processor_seconds([&] { drawing.redraw(0, 1, found.style); }));
    }
}

void add_redraws(Drawing& drawing, double budget, MeshFigures& figures) {
    const std::vector<NamedStyle> styles = kind_styles();
    std::vector<Contender> contenders;
    for (const int threads : {1, 2})
        for (const NamedStyle& style : styles)
            contenders.push_back(
                {style.key, style.text,
                 [&, threads](std::size_t view) { drawing.redraw(view, threads, style.style); },
                 threads == 1});
    for (const Contender& contender : contenders)
        contender.run(0);  // allocates
    Turns turns;
    turns.cases = drawing.view_count();
    turns.budget = budget;
    const int rounds = take_turns(contenders, turns);
    std::fprintf(stderr, "medians of %d rounds\n", rounds);
    const double contours = contenders.front().median();
    for (std::size_t i = 0; i < styles.size(); ++i) {
        const Contender &one = contenders[i], &two = contenders[styles.size() + i];
        const double time = one.median(), time_of_two = two.median();
        figures.add(kRedraw, one.key, one.text, 1e3 * time);
        figures.add(kFrames, one.key, one.text, 1 / time);
        figures.add(kToContours, one.key, one.text, time / contours);
        if (omp_get_num_procs() < 2) continue;
        figures.add(kTwoThreads, one.key, one.text, 1e3 * time_of_two);
        figures.add(kThreads, one.key, one.text, time / time_of_two);
    }
}

MeshFigures measure(const std::string& file, double budget) {
    MeshFigures figures{test_meshes::mesh_name(file)};
    std::fprintf(stderr, "measuring %s\n", figures.name.c_str());
    const TriangleMesh mesh = test_meshes::read_mesh(file);
    figures.add(kSize, "triangles", "triangles", double(mesh.triangles.size()));
    const Field field = precompute(mesh, field_options(true));
    std::unique_ptr<Drawing> drawing;
    omp_set_num_threads(1);
    const double building =
        processor_seconds([&] { drawing = std::make_unique<Drawing>(mesh, field); });
    add_finding(*drawing, figures);
    add_redraws(*drawing, budget, figures);
    add_fields(mesh, figures);
    figures.add(kOnce, "extractor", "building the extractor, one thread", building);
    return figures;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Arguments arguments = parse(argc, argv);
        std::vector<MeshFigures> columns;
        for (const std::string& file : arguments.files)
            columns.push_back(measure(file, arguments.seconds));
        for (const MeshFigures& others : published_figures())
            columns.push_back(others);
        std::printf("%s\n\n%s\n%s", machine_text().c_str(), markdown_table(columns).c_str(),
                    kPublishedNote);
        if (!arguments.json.empty() &&
            !(std::ofstream(arguments.json) << json_report(columns) << std::flush))
            throw std::runtime_error("cannot write " + arguments.json);
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr, "paper_table: %s\npaper_table [--seconds S] [--json FILE] MESH...\n",
                     error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "paper_table: %s\n", error.what());
        return 1;
    }
}
