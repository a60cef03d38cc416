// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_table.h"

#include <cstdarg>
#include <cstdio>
#include <functional>

namespace benchmarks {
namespace {

std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));

std::string text(const char* format, ...) {
    char buffer[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof(buffer), format, arguments);
    va_end(arguments);
    return buffer;
}

double percent(double part, double all) {
    return all > 0 ? 100 * part / all : 0;
}

std::string deflection_of(const ScoredDrawing& drawing) {
    return text("%g / %g", drawing.linear, drawing.angular);
}

std::string row(const std::string& title, const ScoredDrawings& drawings) {
    const TruthMeans means(drawings);
    const TruthScores& sum = means.sum;
    return text("| %s | %zu | %.4f | %.4f | %.3f | %.3f | %.3f | %.2f | %.2f | %d of %d |\n",
                title.c_str(), means.drawings, means.recall, means.precision, means.least_recall,
                means.least_precision, sum.rms(), percent(sum.doubled, sum.drawn),
                percent(sum.loose_ends, sum.ends), sum.closed_outlines, sum.outlines);
}

ScoredDrawings those(const ScoredDrawings& drawings,
                     const std::function<bool(const ScoredDrawing&)>& are_wanted) {
    ScoredDrawings result;
    for (const ScoredDrawing& drawing : drawings)
        if (are_wanted(drawing)) result.push_back(drawing);
    return result;
}

}  // namespace

std::string ScoredDrawing::name() const {
    return text("%s %g_%g %s", part.c_str(), linear, angular, view.c_str());
}

TruthMeans::TruthMeans(const ScoredDrawings& all) : drawings(all.size()) {
    if (all.empty()) return;
    recall = precision = 0;
    for (const ScoredDrawing& drawing : all) {
        recall += drawing.scores.recall() / double(all.size());
        precision += drawing.scores.precision() / double(all.size());
        least_recall = std::min(least_recall, drawing.scores.recall());
        least_precision = std::min(least_precision, drawing.scores.precision());
        sum.add(drawing.scores);
    }
}

std::string truth_table(const ScoredDrawings& drawings) {
    std::string table =
        "| deflection, mm / rad | drawings | recall | precision | least recall | least precision | "
        "rms, mm | doubled, % | loose ends, % | closed outlines |\n"
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    std::vector<std::string> deflections;
    for (const ScoredDrawing& drawing : drawings)
        if (std::find(deflections.begin(), deflections.end(), deflection_of(drawing)) ==
            deflections.end())
            deflections.push_back(deflection_of(drawing));
    for (const std::string& deflection : deflections) {
        const ScoredDrawings of_deflection =
            those(drawings, [&](const ScoredDrawing& d) { return deflection_of(d) == deflection; });
        table += row(deflection, of_deflection);
        for (std::size_t c = 0; c < direction_class_names.size(); ++c) {
            const ScoredDrawings of_class = those(of_deflection, [&](const ScoredDrawing& d) {
                return d.direction_class == DirectionClass(c);
            });
            if (!of_class.empty())
                table += row(deflection + " " + direction_class_names[c], of_class);
        }
    }
    return table;
}

std::string worst_drawings(ScoredDrawings drawings, std::size_t count) {
    std::sort(drawings.begin(), drawings.end(), [](const ScoredDrawing& a, const ScoredDrawing& b) {
        return a.scores.worst() < b.scores.worst();
    });
    std::string table =
        "| worst drawings | recall | precision | longest missed, mm | longest wrong, mm |\n"
        "|---|--:|--:|--:|--:|\n";
    for (std::size_t i = 0; i < drawings.size() && i < count; ++i)
        table += text("| %s | %.4f | %.4f | %.1f | %.1f |\n", drawings[i].name().c_str(),
                      drawings[i].scores.recall(), drawings[i].scores.precision(),
                      drawings[i].longest_missed, drawings[i].longest_wrong);
    return table;
}

}  // namespace benchmarks
