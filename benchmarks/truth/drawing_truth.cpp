// SPDX-License-Identifier: GPL-3.0-or-later
// drawing_truth [OPTIONS] FILE.part...
// Holds measured drawings of CAD parts against their exact visible lines, which make_parts.py has
// written: recall, precision, position, doubled lines, loose ends and closed outlines, for each
// deflection of the meshes and each class of directions, and the worst drawings.
//   --left-out FILE        parts and directions whose exact lines are wrong
//   --deflection L/A       only meshes of this deflection, mm and rad, as 0.1/0.3; repeated for
//   more
//   --from TEXT            only directions with this in their names; repeated for more
//   --pictures FOLDER      of drawings that miss or add more than --size MM (2) in one piece
//   --least-recall X, --least-precision X, --most-loose PERCENT
//                          fails where the means of all drawings are beyond
#include <cstdio>
#include <stdexcept>

#include "command_words.h"
#include "left_out.h"
#include "truth_picture.h"
#include "truth_table.h"

namespace {

using namespace benchmarks;

constexpr double tolerance = 0.25;       // mm
constexpr double fine_deflection = 0.1;  // up to this one, a mesh has no tolerance of its own
constexpr std::size_t worst_count = 10;

struct Arguments {
    LeftOut left_out;
    std::vector<std::string> deflections, directions;
    QString pictures;
    double picture_size = 2;
    double least_recall = 0, least_precision = 0, most_loose = 100;
    std::vector<std::string> files;
};

double number(const std::string& option, const std::string& text) {
    std::size_t read = 0;
    double value = NAN;
    try {
        value = std::stod(text, &read);
    } catch (const std::exception&) {
    }
    if (read != text.size() || !(value >= 0))
        throw std::invalid_argument(option + " needs a number, not " + text);
    return value;
}

Arguments parse(int argc, char** argv) {
    Arguments result;
    const auto set = [&](const std::string& argument, const std::string& value) {
        if (argument == "--left-out")
            result.left_out = LeftOut(QString::fromStdString(value));
        else if (argument == "--deflection")
            result.deflections.push_back(value);
        else if (argument == "--from")
            result.directions.push_back(value);
        else if (argument == "--pictures")
            result.pictures = QString::fromStdString(value);
        else if (argument == "--size")
            result.picture_size = number(argument, value);
        else if (argument == "--least-recall")
            result.least_recall = number(argument, value);
        else if (argument == "--least-precision")
            result.least_precision = number(argument, value);
        else if (argument == "--most-loose")
            result.most_loose = number(argument, value);
        else
            return false;
        return true;
    };
    result.files = files_among(argc, argv, set);
    if (result.files.empty()) throw std::invalid_argument("no file is named");
    return result;
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
        if (!arguments_.pictures.isEmpty() &&
            std::max(details.longest_missed, details.longest_wrong) > arguments_.picture_size)
            write_truth_picture(picture_of(drawings.back()), drawing, exact, details);
    }
    QString picture_of(const ScoredDrawing& drawing) const {
        return arguments_.pictures + "/" +
               QString::fromStdString(drawing.name()).replace(' ', '_') + ".png";
    }

    const Arguments& arguments_;
};

/// Whether the means keep the bounds that were asked for; says which do not.
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

bool run(const Arguments& arguments) {
    Measuring measuring(arguments);
    for (const std::string& file : arguments.files) {
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
    try {
        return run(parse(argc, argv)) ? 0 : 1;
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr, "drawing_truth: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "drawing_truth: %s\n", error.what());
        return 1;
    }
}
