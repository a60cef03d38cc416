// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_report.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace benchmarks {
namespace {

constexpr std::size_t kWorst = 10;

Spread outline_of(const MeasuredDrawing& drawing) {
    return spread(drawing.measures, &ViewMeasures::outline);
}

template <class... Values>
std::string format(const char* pattern, Values... values) {
    char text[200];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

std::string share_text(bool is_known, double value) {
    return is_known ? format("%8.4f", value) : "       -";
}

/// Such as 3o: the fourth view, an orthographic one.
std::string view_text(const MeshMeasures& mesh, int view) {
    if (view < 0) return "   -";
    return format("%3d%c", view, mesh.views[std::size_t(view)].is_perspective ? 'p' : 'o');
}

std::string row(const MeasuredDrawing& drawing) {
    const MeshMeasures& mesh = drawing.measures;
    const Spread outline = outline_of(drawing), strays = spread(mesh, &ViewMeasures::strays),
                 edges = spread(mesh, &ViewMeasures::edges);
    return format("%-24s %-5s %8zu ", drawing.name.c_str(), drawing.is_sharp ? "sharp" : "",
                  mesh.triangles) +
           view_text(mesh, outline.least_view) + share_text(outline.is_known(), outline.least) +
           share_text(outline.is_known(), outline.mean) + " " +
           share_text(strays.is_known(), strays.most) + share_text(strays.is_known(), strays.mean) +
           " " + share_text(edges.is_known(), edges.least) +
           share_text(edges.is_known(), edges.mean) + "\n";
}

/// Mean over the meshes of which a share is known.
class Mean {
public:
    void add(const Spread& spread) {
        if (!spread.is_known()) return;
        sum_ += spread.mean;
        ++count_;
    }
    std::string text() const { return count_ ? format("%.3f", sum_ / count_) : "-"; }

private:
    double sum_ = 0;
    int count_ = 0;
};

using Choice = std::function<bool(const MeasuredDrawing&)>;

std::string summary_line(const std::vector<MeasuredDrawing>& drawings, const char* name,
                         const Choice& is_meant) {
    int count = 0, complete = 0;
    Mean outline, strays, edges;
    for (const MeasuredDrawing& drawing : drawings) {
        const Spread spread_of_outline = outline_of(drawing);
        if (!is_meant(drawing) || !spread_of_outline.is_known()) continue;
        ++count;
        complete += spread_of_outline.mean >= kComplete;
        outline.add(spread_of_outline);
        strays.add(spread(drawing.measures, &ViewMeasures::strays));
        edges.add(spread(drawing.measures, &ViewMeasures::edges));
    }
    if (!count) return {};
    return format("%-12s %6d  %6d (%3.0f %%)  %8s %8s %8s\n", name, count, complete,
                  100.0 * complete / count, outline.text().c_str(), strays.text().c_str(),
                  edges.text().c_str());
}

}  // namespace

void sort_by_worst(std::vector<MeasuredDrawing>& drawings) {
    const auto key = [](const MeasuredDrawing& drawing) {
        const Spread outline = outline_of(drawing);
        return std::make_tuple(!outline.is_known(), outline.least, outline.mean, drawing.name);
    };
    std::stable_sort(drawings.begin(), drawings.end(),
                     [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

std::string drawing_table(const std::vector<MeasuredDrawing>& drawings) {
    std::string text = format("%-24s %-5s %8s  outline drawn       strays           edges drawn\n",
                              "mesh", "", "triangl.") +
                       format("%-40sview   worst    mean    worst    mean    worst    mean\n", "");
    for (const MeasuredDrawing& drawing : drawings)
        text += row(drawing);
    return text;
}

std::string drawing_summary(const std::vector<MeasuredDrawing>& drawings) {
    std::string text = "means of    meshes  drawn >= .995   outline   strays    edges\n";
    text += summary_line(drawings, "all", [](const auto&) { return true; });
    for (const char* group : {"registered", "primitives", "files"})
        text += summary_line(drawings, group, [&](const auto& d) { return d.group == group; });
    text += summary_line(drawings, "sharp", [](const auto& d) { return d.is_sharp; });
    text += summary_line(drawings, "not sharp", [](const auto& d) { return !d.is_sharp; });
    text += "the worst:";
    for (std::size_t i = 0; i < std::min(kWorst, drawings.size()); ++i)
        text += " " + drawings[i].name;
    return text + "\n";
}

std::vector<MeshFigures> drawing_figures(const std::vector<MeasuredDrawing>& drawings) {
    const struct {
        Section section;
        Share ViewMeasures::*share;
    } sections[] = {{{"outline", nullptr}, &ViewMeasures::outline},
                    {{"strays", nullptr}, &ViewMeasures::strays},
                    {{"edges", nullptr}, &ViewMeasures::edges}};
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<MeshFigures> meshes;
    for (const MeasuredDrawing& drawing : drawings) {
        meshes.push_back({drawing.name});
        const Section size{"size", nullptr};
        meshes.back().add(size, "triangles", "", double(drawing.measures.triangles));
        meshes.back().add(size, "sharp", "", drawing.is_sharp);
        for (const auto& [section, share] : sections) {
            const Spread s = spread(drawing.measures, share);
            for (const auto& [key, value] :
                 {std::pair{"mean", s.mean}, {"least", s.least}, {"most", s.most}})
                meshes.back().add(section, key, "", s.is_known() ? value : unknown);
        }
    }
    return meshes;
}

void write_picture(const DrawnView& view, const std::string& file) {
    const int size = view.surface.size();
    const PixelMask near_lines = view.lines.grown(kReach);
    std::string pixels = format("P6\n%d %d\n255\n", size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            if (view.lines.has(x, y))
                pixels += std::string(3, '\0');
            else if (view.outline.has(x, y) && !near_lines.has(x, y))
                pixels += "\xff\x20\x20";
            else
                pixels += view.surface.has(x, y) ? "\xc8\xe8\xc8" : "\xff\xff\xff";
        }
    if (!(std::ofstream(file, std::ios::binary) << pixels << std::flush))
        throw std::runtime_error("cannot write " + file);
}

}  // namespace benchmarks
