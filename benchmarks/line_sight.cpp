// SPDX-License-Identifier: GPL-3.0-or-later
// line_sight [--forms yes|no] [--where yes|no] [MESH...]
// How well it is decided which parts of contours are seen. Of forms that are known exactly, by
// meshes of growing fineness and a dozen views: the share of the length of all contours that is
// hidden but judged seen, and seen but judged hidden. Of these and of the meshes that are named, by
// their six sides: how many ends the seen contours have, how many are T-junctions, cusps, or ends
// where another outline goes on, and the share that is none of these, loose. An end and what
// explains it are within 0.3 % of D in the picture. --where yes lists what is misjudged.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/precompute.h"
#include "line_ends.h"
#include "mesh_file.h"
#include "sight_truth.h"
#include "turns.h"

namespace {

using namespace benchmarks;
using namespace laplacian_lines;
using Eigen::Vector3d;

constexpr double kReach = 0.003;        // of ends, in D
constexpr double kContourReach = 0.02;  // of contours from the true ones, in D
constexpr double kOnLine = 1e-6;        // in D
constexpr int kViews = 12;

/// Evenly over the sphere, none along an axis.
std::vector<Vector3d> directions_around() {
    std::vector<Vector3d> result;
    for (int i = 0; i < kViews; ++i) {
        const double z = (2 * i + 1.0) / kViews - 1, angle = 2.399963 * i + 0.5;
        const double radius = std::sqrt(1 - z * z);
        result.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return result;
}

std::vector<Vector3d> six_sides() {
    std::vector<Vector3d> result;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1., -1.})
            result.push_back(sign * Vector3d::Unit(axis));
    return result;
}

/// Successive segments that are misjudged in the same way.
struct Stretch {
    int view;
    std::uint32_t first, last;  // points of the view's lines
    bool is_drawn;
    double length;                    // in D
    double radial_begin, radial_end;  // curvatures towards the eye, 0 at cusps
};

/// Lengths of contours.
struct Judged {
    double all = 0, wrongly_seen = 0, wrongly_hidden = 0;
    std::vector<Stretch> stretches = {};

    void add_wrong(const Stretch& segment) {
        (segment.is_drawn ? wrongly_seen : wrongly_hidden) += segment.length;
        Stretch* last = stretches.empty() ? nullptr : &stretches.back();
        if (!last || last->view != segment.view || last->last != segment.first ||
            last->is_drawn != segment.is_drawn)
            return stretches.push_back(segment);
        last->last = segment.last;
        last->length += segment.length;
        last->radial_end = segment.radial_end;
    }
};

void print_stretches(const std::vector<Stretch>& stretches) {
    for (const Stretch& s : stretches)
        std::printf(
            "    view %d, points %u to %u: %.2f %% of D wrongly %s, radial curvature %.2f to "
            "%.2f\n",
            s.view, s.first, s.last, 100 * s.length, s.is_drawn ? "seen" : "hidden", s.radial_begin,
            s.radial_end);
}

bool is_on(const LineSet& lines, const Vector3d& p, double within) {
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first; i + 1 < line.first + line.count; ++i) {
            const Vector3d a = lines.points[i].position.cast<double>();
            const Vector3d way = lines.points[i + 1].position.cast<double>() - a;
            const double square = way.squaredNorm();
            const double t = square > 0 ? std::min(1., std::max(0., way.dot(p - a) / square)) : 0;
            if ((a + t * way - p).norm() < within) return true;
        }
    return false;
}

class Drawing {
public:
    explicit Drawing(const TriangleMesh& mesh)
        : field_(precompute(mesh)), extractor_(mesh, field_), visibility_(mesh, field_) {}

    void look(const Vector3d& towards_eye) {
        towards_eye_ = towards_eye;
        ++view_number_;
        view_ = View::orthographic(towards_eye);
        extractor_.extract(view_, {}, scratch_, whole_);
        seconds += benchmarks::seconds([&] { seen_ = visibility_.visible_parts(view_, whole_); });
    }
    void judge(const SightTruth& truth, Judged& judged) const {
        const double d = field_.scale.diagonal;
        for (const Polyline& line : whole_.lines)
            for (std::uint32_t i = line.first;
                 line.kind == LineKind::Contour && i + 1 < line.first + line.count; ++i) {
                const Vector3d a = whole_.points[i].position.cast<double>();
                const Vector3d b = whole_.points[i + 1].position.cast<double>();
                const auto contour = truth.contour_at((a + b) / 2, towards_eye_, kContourReach * d);
                if (!contour) continue;
                const double length = (b - a).norm() / d;
                const bool is_drawn = is_on(seen_, (a + b) / 2, kOnLine * d);
                judged.all += length;
                if (is_drawn != contour->is_seen)
                    judged.add_wrong({view_number_, i, i + 1, is_drawn, length, contour->radial,
                                      contour->radial});
            }
    }
    LineEnds ends() const {
        return ends_of_contours(whole_, seen_, view_, kReach * field_.scale.diagonal);
    }

    double seconds = 0;

private:
    const Field field_;
    const LineExtractor extractor_;
    const LineVisibility visibility_;
    ExtractionScratch scratch_;
    Vector3d towards_eye_;
    int view_number_ = 0;
    View view_;
    LineSet whole_, seen_;
};

void print_row(const std::string& name, std::size_t triangles, const Judged& judged,
               const LineEnds& ends, double seconds) {
    std::printf("%-14s %9zu ", name.c_str(), triangles);
    if (judged.all > 0)
        std::printf("%9.2f %9.2f", 100 * judged.wrongly_seen / judged.all,
                    100 * judged.wrongly_hidden / judged.all);
    else
        std::printf("%9s %9s", "-", "-");
    std::printf(" %6d %6d %6d %6d %6d %7.1f %7.2f\n", ends.all, ends.crossings, ends.cusps,
                ends.meetings, ends.loose(), 100. * ends.loose() / std::max(1, ends.all), seconds);
    std::fflush(stdout);
}

void measure_form(const KnownForm& form, bool says_where) {
    const SightTruth truth = form.truth();
    for (const auto& make : form.meshes) {
        const TriangleMesh mesh = make();
        Drawing drawing(mesh);
        Judged judged;
        LineEnds ends;
        for (const Vector3d& direction : directions_around()) {
            drawing.look(direction);
            drawing.judge(truth, judged);
            ends += drawing.ends();
        }
        print_row(form.name, mesh.triangles.size(), judged, ends, drawing.seconds);
        if (says_where) print_stretches(judged.stretches);
    }
}

void measure_file(const std::string& file) {
    const TriangleMesh mesh = test_meshes::read_mesh(file);
    Drawing drawing(mesh);
    LineEnds ends;
    for (const Vector3d& direction : six_sides()) {
        drawing.look(direction);
        ends += drawing.ends();
    }
    print_row(test_meshes::mesh_name(file), mesh.triangles.size(), {}, ends, drawing.seconds);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::vector<std::string> files(argv + 1, argv + argc);
        const auto option = [&](const char* name, bool otherwise) {
            const auto found = std::find(files.begin(), files.end(), name);
            if (found == files.end() || found + 1 == files.end()) return otherwise;
            const bool is_yes = found[1] == "yes";
            files.erase(found, found + 2);
            return is_yes;
        };
        const bool has_forms = option("--forms", true), says_where = option("--where", false);
        std::printf("%-14s %9s %9s %9s %6s %6s %6s %6s %6s %7s %7s\n", "", "triangles", "seen %",
                    "hidden %", "ends", "cross", "cusps", "meet", "loose", "loose %", "s");
        if (has_forms)
            for (const KnownForm& form : known_forms())
                measure_form(form, says_where);
        for (const std::string& file : files)
            measure_file(file);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "line_sight: %s\n", error.what());
        return 1;
    }
    return 0;
}
