// SPDX-License-Identifier: GPL-3.0-or-later
// Finds where the exact lines are wrong themselves: holds them against an item buffer of the part's
// finest mesh. Prints the directions from which more than --least in one piece of a line lies where
// the item buffer has neither border nor jump nor edge, or of a border or jump has no line: part,
// direction, both lengths. Edges under 8 degrees are none of the item buffer: look at the pictures,
// in which lines without reason are blue and places without a line red, before leaving one out.
#include <cstdio>
#include <stdexcept>

#include "item_buffer.h"
#include "part_file.h"
#include "plane_canvas.h"
#include "plane_lines.h"
#include "program.h"

namespace {

using namespace benchmarks;

constexpr double reach = 0.2;       // mm
constexpr double least_jump = 0.2;  // mm
constexpr double least_turn = 8;    // degrees, more than between facets of the finest mesh
constexpr double pixel = 1 / item_pixels_per_mm;

struct Arguments {
    double least = 2;
    std::string pictures;
};

/// Places as lines of no length, to be found by NearSegments.
NearSegments near_places(const std::vector<PlaneLine>& some, double radius) {
    PlaneLines lines;
    for (const PlaneLine& places : some)
        for (const PlanePoint& p : places)
            lines.push_back({p, p});
    return {lines, radius};
}

/// The longest piece of a line without a place of the item buffer; `parts` takes all.
double longest_without_reason(const PlaneLines& lines, const NearSegments& places,
                              PlaneLines& parts) {
    double longest = 0;
    for (const PlaneLine& line : lines) {
        double run = 0;
        for_each_piece(line, 0.1, [&](const PlanePoint& p, const PlanePoint& way, double length) {
            const bool has_reason = places.any_near(p, [](const NearPlace&) { return true; });
            run = has_reason ? 0 : run + length;
            longest = std::max(longest, run);
            if (!has_reason) parts.push_back({p - way * length / 2, p + way * length / 2});
        });
    }
    return longest;
}

struct Doubts {
    double lines_without_reason = 0;   ///< mm, the longest piece
    double places_without_a_line = 0;  ///< mm, of all
    PlaneLines wrong;
    PlaneLine missed;
};

Doubts doubts_of(const ItemBuffer& items, const ExactView& view) {
    const std::vector<PlaneLine> certain = {items.border(), items.jumps(least_jump)};
    std::vector<PlaneLine> all = certain;
    all.push_back(items.edges(least_turn));
    Doubts doubts;
    doubts.lines_without_reason =
        longest_without_reason(view.demanded, near_places(all, reach), doubts.wrong);
    const NearSegments lines(view.demanded, reach);
    for (const PlaneLine& places : certain)
        for (const PlanePoint& p : places)
            if (!lines.any_near(p, [](const NearPlace&) { return true; }))
                doubts.missed.push_back(p);
    doubts.places_without_a_line = double(doubts.missed.size()) * pixel;
    return doubts;
}

void draw(const Doubts& doubts, const ItemBuffer& items, const ExactView& view,
          const QString& file) {
    PlaneCanvas canvas({items.place(0, 0), items.place(items.width(), items.height())});
    for (const PlaneLine& places :
         {items.border(), items.jumps(least_jump), items.edges(least_turn)})
        for (const PlanePoint& p : places)
            canvas.dot(p, QColor(215, 215, 215));
    canvas.draw(view.demanded, Qt::black, 1);
    canvas.draw(doubts.wrong, Qt::blue, 3);
    for (const PlanePoint& p : doubts.missed)
        canvas.dot(p, Qt::red);
    canvas.save(file);
}

void check(const CadPart& part, const Arguments& arguments) {
    if (part.meshes.empty()) throw std::runtime_error(part.name + " has no mesh");
    for (const ExactView& view : part.views) {
        const ItemBuffer items(part.meshes.back().mesh, view.frame, {});
        const Doubts doubts = doubts_of(items, view);
        if (std::max(doubts.lines_without_reason, doubts.places_without_a_line) <= arguments.least)
            continue;
        std::printf("%s\t%s\t%.1f\t%.1f\n", part.name.c_str(), view.name.c_str(),
                    doubts.lines_without_reason, doubts.places_without_a_line);
        std::fflush(stdout);
        if (arguments.pictures.empty()) continue;
        const std::string file = arguments.pictures + "/" + part.name + " " + view.name + ".png";
        draw(doubts, items, view, QString::fromStdString(file).replace(' ', '_'));
    }
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    const std::vector<Option> options = {
        number("--least MM", "that are told (2)", arguments.least),
        text("--pictures FOLDER", "of what is told", arguments.pictures)};
    return run_program(argc, argv, "FILE.part...", options, [&](const auto& files) {
        for (const std::string& file : files)
            check(read_part(QString::fromStdString(file)), arguments);
        return true;
    });
}
