// SPDX-License-Identifier: GPL-3.0-or-later
// drawing_truth [OPTIONS] FILE.part...
// Compares measured drawings of CAD parts with their exact visible lines by make_parts.py: recall,
// precision, position, doubled lines, loose ends and closed outlines, for each deflection and class
// of directions, and the worst drawings.
#include <cstdio>
#include <stdexcept>

#include "plane_canvas.h"
#include "program.h"
#include "truth_table.h"

namespace {

using namespace benchmarks;

constexpr double tolerance = 0.25;       // mm
constexpr double fine_deflection = 0.1;  // up to this one, a mesh has no tolerance of its own
constexpr std::size_t worst_count = 10;

struct Arguments {
    LeftOut left_out;
    std::vector<std::string> deflections, directions;
    std::string pictures;
    double picture_size = 2;
    double least_recall = 0, least_precision = 0, most_loose = 100;
};

std::vector<Option> options_of(Arguments& a) {
    return {{"--left-out FILE", "parts and directions whose exact lines are wrong",
             [&a](const std::string& file) { a.left_out = LeftOut(QString::fromStdString(file)); }},
            {"--deflection L/A", "only meshes of this deflection, mm and rad; repeated for more",
             [&a](const std::string& text) { a.deflections.push_back(text); }},
            {"--from TEXT", "only directions with this in their names; repeated for more",
             [&a](const std::string& text) { a.directions.push_back(text); }},
            text("--pictures FOLDER", "of drawings that miss or add more than --size", a.pictures),
            number("--size MM", "in one piece (2)", a.picture_size),
            number("--least-recall X", "fails where the mean of all is less", a.least_recall),
            number("--least-precision X", "likewise", a.least_precision),
            number("--most-loose PERCENT", "fails where more ends are loose", a.most_loose)};
}

QColor color_of(Mistake mistake) {
    switch (mistake) {
        case Mistake::Missed:
            return Qt::red;
        case Mistake::Wrong:
            return Qt::blue;
        default:
            return QColor(0, 170, 0);
    }
}

/// A PNG at 10 pixels per mm: exact lines light gray (tangent edges lighter), drawn ones thin and
/// black; missed red, wrong blue, doubled green, loose ends in orange rings.
/// @throws std::runtime_error
void write_truth_picture(const QString& file, const DrawnPaths& drawing, const ExactLines& exact,
                         const TruthDetails& details) {
    const PlaneLines lines = lines_of(drawing);
    PlaneCanvas canvas(box_of(lines).merged(box_of(exact.demanded)).merged(box_of(exact.allowed)));
    canvas.draw(exact.allowed, QColor(225, 225, 245), 5);
    canvas.draw(exact.demanded, QColor(205, 205, 205), 5);
    canvas.draw(lines, Qt::black, 1);
    for (const MistakenPart& part : details.parts)
        canvas.draw(part.points, color_of(part.mistake), 3);
    for (const PlanePoint& p : details.loose_ends)
        canvas.ring(p, QColor(255, 140, 0));
    canvas.save(file);
}

class Measuring {
public:
    explicit Measuring(const Arguments& arguments) : arguments_(arguments) {}

    void add(const CadPart& part) {
        const std::vector<const ExactView*> views = wanted_views(part);
        std::vector<PlaneFrame> frames;
        for (const ExactView* view : views)
            frames.push_back(view->frame);
        if (frames.empty()) return;
        for (const PartMesh& mesh : part.meshes) {
            if (!is_wanted(mesh)) continue;
            const std::vector<DrawnPaths> drawn = drawings_of(mesh.mesh, frames);
            for (std::size_t i = 0; i < views.size(); ++i)
                add(part, mesh, *views[i], drawn[i]);
        }
    }

    ScoredDrawings drawings;

private:
    bool is_wanted(const PartMesh& mesh) const {
        char name[64];
        std::snprintf(name, sizeof(name), "%g/%g", mesh.linear, mesh.angular);
        const auto& wanted = arguments_.deflections;
        return wanted.empty() || std::count(wanted.begin(), wanted.end(), name);
    }
    std::vector<const ExactView*> wanted_views(const CadPart& part) const {
        std::vector<const ExactView*> views;
        const auto& wanted = arguments_.directions;
        for (const ExactView& view : part.views)
            if (!arguments_.left_out.has(part.name, view.name) &&
                (wanted.empty() || std::any_of(wanted.begin(), wanted.end(), [&](const auto& word) {
                     return view.name.find(word) != std::string::npos;
                 })))
                views.push_back(&view);
        return views;
    }
    void add(const CadPart& part, const PartMesh& mesh, const ExactView& view,
             const DrawnPaths& drawing) {
        const double slack = mesh.linear > fine_deflection ? mesh.linear : 0;
        const ExactLines exact{view.demanded, view.allowed};
        TruthDetails details;
        const TruthScores scores = score(drawing, exact, tolerance + slack, slack, &details);
        drawings.push_back({part.name, view.name, view.direction_class, mesh.linear, mesh.angular,
                            scores, details.longest_missed, details.longest_wrong});
        if (!arguments_.pictures.empty() &&
            std::max(details.longest_missed, details.longest_wrong) > arguments_.picture_size)
            write_truth_picture(picture_of(drawings.back()), drawing, exact, details);
    }
    QString picture_of(const ScoredDrawing& drawing) const {
        return QString::fromStdString(arguments_.pictures + "/" + drawing.name() + ".png")
            .replace(' ', '_');
    }

    const Arguments& arguments_;
};

/// Reports the bounds that are not kept.
bool keeps_bounds(const TruthMeans& means, const Arguments& arguments) {
    const double loose = means.sum.ends ? 100. * means.sum.loose_ends / means.sum.ends : 0;
    const bool recalls = means.recall >= arguments.least_recall;
    const bool is_precise = means.precision >= arguments.least_precision;
    const bool is_joined = loose <= arguments.most_loose;
    if (!recalls) std::fprintf(stderr, "drawing_truth: recall is %.4f\n", means.recall);
    if (!is_precise) std::fprintf(stderr, "drawing_truth: precision is %.4f\n", means.precision);
    if (!is_joined) std::fprintf(stderr, "drawing_truth: %.2f %% of ends are loose\n", loose);
    return recalls && is_precise && is_joined;
}

bool run(const Arguments& arguments, const std::vector<std::string>& files) {
    Measuring measuring(arguments);
    for (const std::string& file : files) {
        std::fprintf(stderr, "drawing %s\n", file.c_str());
        measuring.add(read_part(QString::fromStdString(file)));
    }
    if (measuring.drawings.empty())
        throw std::runtime_error("no part has such a deflection and direction");
    std::printf("%s\n%s", truth_table(measuring.drawings).c_str(),
                worst_drawings(measuring.drawings, worst_count).c_str());
    return keeps_bounds(TruthMeans(measuring.drawings), arguments);
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    return run_program(argc, argv, "FILE.part...", options_of(arguments),
                       [&](const auto& files) { return run(arguments, files); });
}
