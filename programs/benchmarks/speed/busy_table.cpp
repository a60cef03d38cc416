// SPDX-License-Identifier: GPL-3.0-or-later
// ./bench --busy: the main figures on a loaded machine beside those on an idle one, taken in turns;
// medians by the clock.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <stdexcept>
#include <thread>

#include "laplacian_lines/precompute.h"
#include "laplacian_lines/threads.h"
#include "mesh_file.h"
#include "neighbours.h"
#include "program.h"
#include "redraws.h"
#include "report.h"
#ifdef HAS_FILTERS
#include "add_layer.h"
#include "filters.h"
#endif

namespace {

using namespace benchmarks;
using namespace laplacian_lines;

const Section kTimes{"ms", "ms"};
const Section kRatios{"ratios", "Ratios"};
const Section kMemory{"memory", "Memory"};

constexpr int kRoundsOfCommands = 3;

struct LoadName {
    Load load;
    const char* name;
};
constexpr std::array<LoadName, 4> kLoads = {{{Load::Quiet, "quiet"},
                                             {Load::Stream, "memory streamed"},
                                             {Load::Cores, "other cores busy"},
                                             {Load::AllCores, "all cores busy"}}};

/// One figure with its seconds by load and round.
struct Work {
    std::string key, text;
    std::function<double()> seconds_of_one;
    int most_rounds = std::numeric_limits<int>::max();
    std::array<std::vector<double>, kLoads.size()> times = {};

    double median(std::size_t load) const {
        std::vector<double> sorted = times[load];
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }
};

Work redraw(Contender contender, std::size_t eyes) {
    const auto all = [run = contender.run, eyes] {
        for (std::size_t eye = 0; eye < eyes; ++eye)
            run(eye);
    };
    all();  // allocates
    return {contender.key, contender.text, [all, eyes] { return seconds(all) / double(eyes); }};
}

void add_redraws(Redraws& redraws, std::vector<Work>& works) {
    for (Contender& contender : redraws.fast())
        if (contender.key == "lines" || contender.key == "lines_two_threads")
            works.push_back(redraw(std::move(contender), redraws.view_count()));
    works.push_back(redraw(redraws.plain().front(), redraws.view_count()));
}

/// Stores the last run's processor time in `processor`.
Work field(const TriangleMesh& mesh, double& processor) {
    return {"field", "the field, all threads", [&] {
                set_thread_limit(0);
                const std::clock_t start = std::clock();
                const double time = seconds([&] { precompute(mesh); });
                processor = double(std::clock() - start) / CLOCKS_PER_SEC;
                return time;
            }};
}

double thread_seconds() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// The scheduler's share for as many threads that never wait, until together they have had the
/// processor time, a millisecond at a time.
Work fair_share(const double& processor) {
    return {"fair_share", "as much processor time, of threads that wait for nothing", [&] {
                constexpr double kPiece = 1e-3;
                std::atomic<int> left{int(processor / kPiece)};
                const auto compute = [&] {
                    for (double end = thread_seconds(); left-- > 0;)
                        for (end += kPiece; thread_seconds() < end;) {
                        }
                };
                return seconds([&] {
                    std::vector<std::thread> others(std::thread::hardware_concurrency() - 1);
                    for (std::thread& thread : others)
                        thread = std::thread(compute);
                    compute();
                    for (std::thread& thread : others)
                        thread.join();
                });
            }};
}

Work derivatives(const TriangleMesh& mesh, Field of_mesh) {
    return {"derivatives", "C and the curvatures it goes with, all threads",
            [&mesh, field = std::move(of_mesh)]() mutable {
                set_thread_limit(0);
                return seconds([&] { add_curvature_derivatives(mesh, field); });
            }};
}

/// `text`: LABEL=COMMAND
Work command(const std::string& text) {
    const std::size_t end = text.find('=');
    const std::string label = text.substr(0, end), words = text.substr(end + 1);
    return {label, label,
            [words] {
                return seconds([&] {
                    if (std::system(words.c_str()) != 0)
                        throw std::runtime_error("failed: " + words);
                });
            },
            kRoundsOfCommands};
}

#ifdef HAS_FILTERS
Work filter(MeshDocument& document) {
    return {"filter", "the filter with its dialog's defaults, in MeshLab's document", [&document] {
                set_thread_limit(0);
                const ComputeFilter compute;
                return seconds([&] {
                    RichParameterList list;
                    compute.listParameters(document.mm(), list);
                    meshlab_host::FilterResults results;
                    compute.run({document, list, nullptr, [](const QString&) {}, results});
                });
            }};
}
#endif

void take_turns(std::vector<Work>& works, const Neighbours& neighbours, int rounds) {
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < kLoads.size(); ++i) {
            const std::size_t load = (i + std::size_t(round)) % kLoads.size();
            neighbours.set(kLoads[load].load);
            for (Work& work : works)
                if (round < work.most_rounds) work.times[load].push_back(work.seconds_of_one());
        }
    neighbours.set(Load::Quiet);
}

std::vector<MeshFigures> figures_of(const std::string& mesh, const std::vector<Work>& works) {
    std::vector<MeshFigures> columns;
    for (std::size_t load = 0; load < kLoads.size(); ++load) {
        MeshFigures column{mesh + ", " + kLoads[load].name};
        for (const Work& work : works)
            column.add(kTimes, work.key, work.text, 1e3 * work.median(load));
        for (const Work& work : works)
            column.add(kRatios, work.key + "_to_quiet", work.text + " : quiet",
                       work.median(load) / work.median(0));
        const double contours = column.value(kTimes, "plain_contours");
        column.add(kRatios, "field_to_fair_share", "the field : its fair share",
                   column.value(kTimes, "field") / column.value(kTimes, "fair_share"));
        column.add(kRatios, "lines_to_contours", "Laplacian lines and contours : plain contours",
                   column.value(kTimes, "lines") / contours);
        columns.push_back(std::move(column));
    }
    return columns;
}

std::vector<MeshFigures> measure(const std::string& file, const std::vector<std::string>& commands,
                                 const Neighbours& neighbours, int rounds) {
    std::fprintf(stderr, "measuring %s\n", test_meshes::mesh_name(file).c_str());
    const TriangleMesh mesh = test_meshes::read_mesh(file);
    const Field of_mesh = precompute(mesh);
    Redraws redraws(mesh, of_mesh);
    double processor = 0;
    std::vector<Work> works = {field(mesh, processor), fair_share(processor),
                               derivatives(mesh, of_mesh)};
    add_redraws(redraws, works);
#ifdef HAS_FILTERS
    MeshDocument document;
    addLayer(document, "mesh", mesh);
    works.push_back(filter(document));
#endif
    std::transform(commands.begin(), commands.end(), std::back_inserter(works), command);
    take_turns(works, neighbours, rounds);
    std::vector<MeshFigures> columns = figures_of(test_meshes::mesh_name(file), works);
    for (MeshFigures& column : columns)
        column.add(kMemory, "extractor_bytes", "bytes a vertex that the extractor holds",
                   double(redraws.extractor().memory()) / double(mesh.positions.size()));
    return columns;
}

}  // namespace

int main(int argc, char** argv) {
    int rounds = 9;
    std::string json;
    std::vector<std::string> commands;
    const std::vector<Option> options = {
        number("--rounds N", "(9)", rounds, 1),
        text("--json FILE", "all figures", json),
        {"--command LABEL=COMMAND", "times a command of the shell with the last mesh, three rounds",
         [&](const std::string& text) { commands.push_back(text); }}};
    return run_program(argc, argv, "MESH...", options, [&](const auto& files) {
        const Neighbours neighbours;
        std::vector<MeshFigures> columns;
        for (const std::string& file : files)
            for (MeshFigures& column :
                 measure(file, &file == &files.back() ? commands : std::vector<std::string>(),
                         neighbours, rounds))
                columns.push_back(std::move(column));
        print_report(columns, json);
        return true;
    });
}
