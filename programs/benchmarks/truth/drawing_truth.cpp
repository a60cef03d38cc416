// SPDX-License-Identifier: GPL-3.0-or-later
// drawing_truth [--check] [--pictures FOLDER] FILE.part... Compares measured drawings of CAD parts
// with their exact visible lines and with the silhouettes of their meshes; --check fails if they
// are worse than the limits below.
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include "truth_measures.h"

namespace {

using namespace benchmarks;

constexpr double kTolerance = 0.25;       // mm
constexpr double kFineDeflection = 0.1;   // mm; up to it a mesh has no tolerance of its own
constexpr double kCoverTolerance = 0.15;  // mm, from the silhouette of the mesh itself
constexpr double kLeastJump = 0.5;        // mm of depth
constexpr std::size_t kWorstCount = 10;

// Limits of --check, for all drawings of meshes of one deflection.
constexpr double kLeastRecall = 0.995, kLeastPrecision = 0.998;  // means of the drawings
constexpr double kMostLoose = 0.025;  // of all ends; likewise of all places:
constexpr double kMostBareBorder = 1e-4, kMostBareJumps = 0.015;

struct Drawing {
    std::string name, deflection;
    PlaneLines lines;
    TruthScores scores;
    PlaneLine border, jumps;            ///< places of silhouette and depth jumps
    PlaneLine bare_border, bare_jumps;  ///< those without a line

    double worst() const { return std::min(scores.recall, scores.precision); }
};

std::string svg_path(const PlaneLines& lines, const char* stroke, double width) {
    std::string path = "<path fill='none' stroke='" + std::string(stroke) + "' stroke-width='" +
                       std::to_string(width) + "' d='";
    for (const PlaneLine& line : lines)
        for (const PlanePoint& p : line)
            path += (&p == &line.front() ? "M" : "L") + std::to_string(p.x()) + " " +
                    std::to_string(-p.y());
    return path + "'/>\n";
}

/// Exact lines gray, tangent edges lighter, drawn ones thin and black; missed red, wrong blue,
/// loose ends and places without a line orange.
void write_picture(const std::string& folder, const Drawing& drawing, const ExactView& view) {
    Eigen::AlignedBox2d box;
    for (const PlaneLines& lines : {drawing.lines, view.required, view.allowed})
        for (const PlaneLine& line : lines)
            for (const PlanePoint& p : line)
                box.extend(p);
    PlaneLines spots;
    for (const PlaneLine& places :
         {drawing.scores.loose_ends, drawing.bare_border, drawing.bare_jumps})
        for (const PlanePoint& p : places)
            spots.push_back({p - PlanePoint(0.2, 0), p + PlanePoint(0.2, 0)});
    std::filesystem::create_directories(folder);
    const std::string file = folder + "/" + drawing.name + ".svg";
    const Eigen::Vector2d size = box.sizes().array() + 6;
    std::ofstream out(file);
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << size.x() << "mm' height='"
        << size.y() << "mm' viewBox='" << box.min().x() - 3 << " " << -box.max().y() - 3 << " "
        << size.x() << " " << size.y() << "'>\n"
        << svg_path(view.allowed, "#e1e1f5", 0.5) << svg_path(view.required, "#cdcdcd", 0.5)
        << svg_path(drawing.lines, "black", 0.1) << svg_path(drawing.scores.missed, "red", 0.3)
        << svg_path(drawing.scores.wrong, "blue", 0.3) << svg_path(spots, "orange", 0.4)
        << "</svg>\n";
    if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

std::string text_of(const char* format, double a, double b) {
    char text[64];
    std::snprintf(text, sizeof text, format, a, b);
    return text;
}

Drawing drawing_of(const CadPart& part, const PartMesh& mesh, const ExactView& view,
                   const PlaneLines& lines) {
    Drawing drawing;
    drawing.name = part.name + text_of(" %g_%g ", mesh.linear, mesh.angular) + view.frame.name;
    drawing.deflection = text_of("%g / %g", mesh.linear, mesh.angular);
    drawing.lines = lines;
    const double slack = mesh.linear > kFineDeflection ? mesh.linear : 0;
    drawing.scores = score(lines, view.required, view.allowed, kTolerance + slack, slack);
    const ItemBuffer items(mesh.mesh, view.frame);
    drawing.border = items.border();
    drawing.jumps = items.jumps(kLeastJump);
    drawing.bare_border = bare_places(drawing.border, lines, kCoverTolerance);
    drawing.bare_jumps = bare_places(drawing.jumps, lines, kCoverTolerance);
    return drawing;
}

void add_drawings(const std::string& file, const std::string& pictures,
                  std::vector<Drawing>& drawings) {
    std::fprintf(stderr, "drawing %s\n", file.c_str());
    const CadPart part = read_part(file);
    std::vector<line_drawing::ViewFrame> frames;
    for (const ExactView& view : part.views)
        frames.push_back(view.frame);
    for (const PartMesh& mesh : part.meshes) {
        const std::vector<PlaneLines> drawn = drawings_of(mesh.mesh, frames);
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            drawings.push_back(drawing_of(part, mesh, part.views[i], drawn[i]));
            if (!pictures.empty() && drawings.back().worst() < 1)
                write_picture(pictures, drawings.back(), part.views[i]);
        }
    }
}

/// Recall and precision are averaged by drawing, the rest by number.
struct Row {
    int drawings = 0;
    double recall = 0, precision = 0, least_recall = 1, least_precision = 1;
    double ends = 0, loose_ends = 0, border = 0, bare_border = 0, jumps = 0, bare_jumps = 0;

    void add(const Drawing& drawing) {
        const TruthScores& scores = drawing.scores;
        ++drawings;
        recall += (scores.recall - recall) / drawings;
        precision += (scores.precision - precision) / drawings;
        least_recall = std::min(least_recall, scores.recall);
        least_precision = std::min(least_precision, scores.precision);
        ends += scores.ends;
        loose_ends += double(scores.loose_ends.size());
        border += double(drawing.border.size());
        bare_border += double(drawing.bare_border.size());
        jumps += double(drawing.jumps.size());
        bare_jumps += double(drawing.bare_jumps.size());
    }
    bool is_true() const {
        return recall >= kLeastRecall && precision >= kLeastPrecision &&
               loose_ends <= kMostLoose * ends && bare_border <= kMostBareBorder * border &&
               bare_jumps <= kMostBareJumps * jumps;
    }
};

double percent(double part, double all) {
    return all > 0 ? 100 * part / all : 0;
}

/// Prints a row per deflection and the worst drawings; whether all are true enough.
bool print_tables(std::vector<Drawing>& drawings) {
    std::map<std::string, Row> rows;
    for (const Drawing& drawing : drawings)
        rows[drawing.deflection].add(drawing);
    std::printf(
        "| deflection, mm / rad | drawings | recall | precision | least recall | least precision | "
        "loose ends, %% | border without a line, %% | jumps of depth without a line, %% |\n"
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    for (const auto& [deflection, row] : rows)
        std::printf("| %s | %d | %.4f | %.4f | %.3f | %.3f | %.2f | %.3f | %.2f |\n",
                    deflection.c_str(), row.drawings, row.recall, row.precision, row.least_recall,
                    row.least_precision, percent(row.loose_ends, row.ends),
                    percent(row.bare_border, row.border), percent(row.bare_jumps, row.jumps));
    std::sort(drawings.begin(), drawings.end(),
              [](const Drawing& a, const Drawing& b) { return a.worst() < b.worst(); });
    std::printf("\n| worst drawings | recall | precision |\n|---|--:|--:|\n");
    for (std::size_t i = 0; i < std::min(drawings.size(), kWorstCount); ++i)
        std::printf("| %s | %.4f | %.4f |\n", drawings[i].name.c_str(), drawings[i].scores.recall,
                    drawings[i].scores.precision);
    return std::all_of(rows.begin(), rows.end(),
                       [](const auto& row) { return row.second.is_true(); });
}

}  // namespace

int main(int argc, char** argv) try {
    std::string pictures;
    bool checks = false;
    std::vector<Drawing> drawings;
    for (int i = 1; i < argc; ++i)
        if (argv[i] == std::string("--check"))
            checks = true;
        else if (argv[i] == std::string("--pictures") && i + 1 < argc)
            pictures = argv[++i];
        else
            add_drawings(argv[i], pictures, drawings);
    const bool are_true = print_tables(drawings) && !drawings.empty();
    if (checks && !are_true) std::fputs("drawing_truth: drawings are not true enough\n", stderr);
    return checks && !are_true;
} catch (const std::exception& error) {
    std::fprintf(stderr, "drawing_truth: %s\n", error.what());
    return 1;
}
