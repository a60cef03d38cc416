// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a feature is one stroke, and stays it. Three wavy grooves on a plate, on a dome, and
// across three others, from the front: the share of the grooves' length with an inner line within
// √h, strokes per groove, and the share of the lines' length with a groove there. And for each
// mesh, turned ten times by 2 degrees, the share of the length of inner lines visible before and
// after a turn that has no line within .6 mm in the other drawing.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <tuple>

#include "generators.h"
#include "inner_strokes.h"
#include "item_buffer.h"
#include "line_drawing/object.h"
#include "line_scores.h"
#include "mesh_file.h"
#include "mesh_noise.h"
#include "program.h"

namespace {

using namespace benchmarks;

using Eigen::Vector2d, Eigen::Vector3d;
using laplacian_lines::TriangleMesh;

constexpr double pi = 3.141592653589793;
constexpr double width = 50;           // mm
constexpr double groove_reach = 1;     // mm: √h
constexpr double partner_reach = 0.6;  // mm
constexpr double turn = 2 * pi / 180;
constexpr int steps = 10;
constexpr double sample_step = 0.1;  // mm
constexpr double hiding = 0.6;       // mm: what is as much behind is hidden

double hollow(double distance, double deviation) {
    return std::exp(-distance * distance / (2 * deviation * deviation));
}

struct Grooved {
    const char* name;
    TriangleMesh mesh;
    PlaneLines grooves;  // as they look from the front
};

/// 2.8 by 2, convex along y: three wavy grooves along x, and three across them.
Grooved relief(const char* name, double convexity, bool crossing, int columns, double deviation) {
    const auto wave = [](int k, double along) { return 0.6 * k + 0.1 * std::sin(3 * along + k); };
    Grooved result{name, {}, {}};
    const auto height = [&](double x, double y) {
        double depth = 0;
        for (int k = -1; k <= 1; ++k) {
            depth = std::max(depth, deviation * hollow(y - wave(k, x), deviation));
            if (crossing) depth = std::max(depth, deviation * hollow(x - wave(k, y), deviation));
        }
        return -depth - convexity / 2 * y * y;
    };
    result.mesh =
        test_meshes::grid_mesh({columns, columns * 5 / 7},
                               std::function<Vector3d(double, double)>([&](double u, double v) {
                                   const double x = 2.8 * (u - 0.5), y = 2 * (v - 0.5);
                                   return Vector3d(x, y, height(x, y));
                               }));
    for (int k = -1; k <= 1; ++k) {
        result.grooves.emplace_back();
        for (double x = -1.4; x <= 1.4; x += 0.01)
            result.grooves.back().emplace_back(x, wave(k, x));
        if (!crossing) continue;
        result.grooves.emplace_back();
        for (double y = -1; y <= 1; y += 0.01)
            result.grooves.back().emplace_back(wave(k, y), y);
    }
    return result;
}

CurvePoints points_along(const PlaneLines& lines, double step) {
    CurvePoints curves;
    for (const PlaneLine& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i)
            curves.add({line[i - 1].x(), line[i - 1].y(), 0}, {line[i].x(), line[i].y(), 0}, step);
    return curves;
}

void print_grooves(const Grooved& form, double noise) {
    const TriangleMesh mesh =
        noise > 0 ? mesh_noise::with_noise(form.mesh, noise / 100) : form.mesh;
    const PlaneLines strokes = drawn_strokes(mesh, width).inner;
    const double mm = line_drawing::boundsOf(mesh).sizes().x() / width;
    const auto points = [&](const PlaneLines& lines) {
        return points_along(lines, sample_step * mm);
    };
    const CurvePoints grooves = points(form.grooves);
    const auto along = std::count_if(strokes.begin(), strokes.end(), [&](const PlaneLine& stroke) {
        return share_near(points({stroke}), grooves, groove_reach * mm).value() > 0.5;
    });
    const Score score = compare(points(strokes), grooves, groove_reach * mm);
    std::printf(
        "%-8s %7zu triangles, noise %g %%: covered %.2f, strokes a groove %.2f, precision %.2f\n",
        form.name, mesh.triangles.size(), noise, score.recall.value(),
        double(along) / double(form.grooves.size()), score.precision.value());
    std::fflush(stdout);
}

Vector3d turned(const Vector3d& p, double angle) {
    return {std::cos(angle) * p.x() + std::sin(angle) * p.z(), p.y(),
            std::cos(angle) * p.z() - std::sin(angle) * p.x()};
}

/// From the front, as drawn and as filled.
struct SeenMesh {
    /// `mm`: of paper, in mesh units.
    SeenMesh(const TriangleMesh& mesh, double mm)
        : strokes(drawn_strokes(mesh, line_drawing::boundsOf(mesh).sizes().x() / mm)),
          surface(mesh, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1 / mm}) {}

    DrawnStrokes strokes;
    ItemBuffer surface;
};

/// Of the inner lines that are not hidden in the other drawing, the share with a line there.
Share share_with_partners(const SeenMesh& from, const SeenMesh& to, double angle, double mm) {
    const CurvePoints points = points_along(from.strokes.inner, sample_step * mm);
    CurvePoints seen;
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const Vector2d p = points.points[i].head<2>();
        const auto depth = from.surface.depth_at(p / mm);
        if (!depth) continue;
        const Vector3d moved = turned({p.x(), p.y(), *depth * mm}, angle);
        const auto before = to.surface.depth_at(moved.head<2>() / mm);
        if (!before || *before * mm > moved.z() + hiding * mm) continue;
        seen.points.emplace_back(moved.x(), moved.y(), 0);
        seen.lengths.push_back(points.lengths[i]);
    }
    return share_near(seen, points_along(to.strokes.all, sample_step * mm), partner_reach * mm);
}

/// For `steps` turns in sequence.
void print_turns(const std::string& file) {
    TriangleMesh mesh = test_meshes::read_mesh(file);
    const double mm = line_drawing::boundsOf(mesh).sizes().x() / width;
    Share sum;
    SeenMesh before(mesh, mm);
    for (int step = 0; step < steps; ++step) {
        for (Vector3d& p : mesh.positions)
            p = turned(p, turn);
        SeenMesh after(mesh, mm);
        sum += share_with_partners(before, after, turn, mm);
        sum += share_with_partners(after, before, -turn, mm);
        before = std::move(after);
    }
    std::printf("%s, %d turns of 2 degrees: %.1f %% without a partner\n",
                test_meshes::mesh_name(file).c_str(), steps, 100 - 100 * sum.value());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<double> columns = {200, 300, 700}, noise = {0, 20};
    double deviation = 0.03;
    const std::vector<Option> options = {
        numbers("--columns N,N...", "of the grooved forms' grids (200,300,700)", columns),
        numbers("--noise %,%...", "of their mean edge (0,20)", noise),
        number("--deviation D", "of a groove's profile, of 2.8 (.03)", deviation, 0.001)};
    return run_program(argc, argv, "[MESH...]", options, [&](const auto& files) {
        for (const auto& [name, convexity, crossing] :
             {std::tuple("plate", 0., false), {"dome", 0.7, false}, {"crossing", 0., true}})
            for (const double n : columns)
                for (const double percent : noise)
                    print_grooves(relief(name, convexity, crossing, int(n), deviation), percent);
        for (const std::string& file : files)
            print_turns(file);
        return true;
    });
}
