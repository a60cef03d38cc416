// SPDX-License-Identifier: GPL-3.0-or-later
// crease_truth [--angle DEGREES] [--each] [--facets] MESH.obj...: creases against the edges that a
// CAD program knows. Beside each mesh lies MESH.edges, which names the edges of the mesh that are
// edges between faces of the part: two vertices, counted from 0, and the angle between the faces
// there. Sharp is what has 3 degrees; what has less but more than 1 counts neither way. --angle
// has plain angles between triangles in place of creases. --each has a line for each mesh, --facets
// one for each edge that is wrong.
#include <array>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/precompute.h"
#include "mesh_file.h"

namespace {

using namespace laplacian_lines;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

constexpr double kDegrees = 57.29577951308232;
constexpr double kSharp = 3, kSmooth = 1;  // degrees

struct Options {
    double angle = 0;
    bool each = false, facets = false;
    std::vector<std::string> meshes;
};

struct Sums {
    double sharp = 0, found = 0, drawn = 0, right = 0;

    double recall() const { return sharp > 0 ? found / sharp : 1; }
    double precision() const { return drawn > 0 ? right / drawn : 1; }
    void add(const Sums& other) {
        sharp += other.sharp;
        found += other.found;
        drawn += other.drawn;
        right += other.right;
    }
};

/// Angles between the triangles at edges of two triangles.
std::map<Edge, double> angles_of(const TriangleMesh& mesh) {
    std::map<Edge, std::vector<Eigen::Vector3d>> normals;
    for (const Triangle& t : mesh.triangles) {
        const auto& p = mesh.positions;
        const Eigen::Vector3d n = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized();
        for (std::size_t k = 0; k < 3; ++k)
            normals[std::minmax(t[k], t[(k + 1) % 3])].push_back(n);
    }
    std::map<Edge, double> angles;
    for (const auto& [edge, n] : normals)
        if (n.size() == 2)
            angles[edge] = std::atan2(n[0].cross(n[1]).norm(), n[0].dot(n[1])) * kDegrees;
    return angles;
}

/// Vertices by place, to within what floats leave of it.
class Places {
public:
    explicit Places(const TriangleMesh& mesh) : mesh_(mesh) {
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
            by_x_.emplace(mesh.positions[v].x(), v);
    }

    std::uint32_t nearest(const Eigen::Vector3d& p) const {
        constexpr double reach = 1e-3;
        std::uint32_t best = 0;
        double least = 1e30;
        for (auto it = by_x_.lower_bound(p.x() - reach);
             it != by_x_.end() && it->first < p.x() + reach; ++it) {
            const double d = (mesh_.positions[it->second] - p).squaredNorm();
            if (d < least) {
                least = d;
                best = it->second;
            }
        }
        return best;
    }

private:
    const TriangleMesh& mesh_;
    std::multimap<double, std::uint32_t> by_x_;
};

std::set<Edge> creases_of(const TriangleMesh& mesh) {
    LineStyle style;
    style.shows = LineKindSet();
    style.shows[LineKind::Crease] = true;
    LineSet lines;
    ExtractionScratch scratch;
    LineExtractor(mesh, precompute(mesh))
        .extract(View::perspective({1000, 1000, 1000}), style, scratch, lines);
    const Places places(mesh);
    std::set<Edge> edges;
    for (const Polyline& line : lines.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
            edges.insert(std::minmax(places.nearest(lines.points[i - 1].position.cast<double>()),
                                     places.nearest(lines.points[i].position.cast<double>())));
    return edges;
}

std::map<Edge, double> read_edges(const std::string& mesh) {
    std::ifstream in(mesh.substr(0, mesh.rfind('.')) + ".edges");
    std::map<Edge, double> edges;
    std::uint32_t a, b;
    for (double angle; in >> a >> b >> angle;)
        edges[std::minmax(a, b)] = angle;
    return edges;
}

void tell(const char* what, const TriangleMesh& mesh, const Edge& edge, double face, double angle) {
    const Eigen::Vector3d p = (mesh.positions[edge.first] + mesh.positions[edge.second]) / 2;
    std::printf("    %s %u %u at %.2f %.2f %.2f length %.2f angle %.1f faces %.1f\n", what,
                edge.first, edge.second, p.x(), p.y(), p.z(),
                (mesh.positions[edge.first] - mesh.positions[edge.second]).norm(), angle, face);
}

Sums compare(const std::string& file, const Options& options) {
    const TriangleMesh mesh = test_meshes::read_mesh(file);
    const std::map<Edge, double> faces = read_edges(file), angles = angles_of(mesh);
    std::set<Edge> drawn;
    if (options.angle > 0) {
        for (const auto& [edge, angle] : angles)
            if (angle >= options.angle) drawn.insert(edge);
    } else {
        drawn = creases_of(mesh);
    }
    Sums sums;
    for (const auto& [edge, angle] : angles) {
        const auto it = faces.find(edge);
        const double face = it == faces.end() ? 0 : it->second;
        const double length = (mesh.positions[edge.first] - mesh.positions[edge.second]).norm();
        const bool is_drawn = drawn.count(edge) > 0;
        if (face >= kSharp) {
            sums.sharp += length;
            sums.found += is_drawn ? length : 0;
        }
        if (is_drawn && (face >= kSharp || face < kSmooth)) {
            sums.drawn += length;
            sums.right += face >= kSharp ? length : 0;
        }
        if (options.facets && is_drawn && face < kSmooth) tell("false", mesh, edge, face, angle);
        if (options.facets && !is_drawn && face >= kSharp) tell("missing", mesh, edge, face, angle);
    }
    return sums;
}

Options read_options(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--angle") && i + 1 < argc)
            options.angle = std::atof(argv[++i]);
        else if (!std::strcmp(argv[i], "--each"))
            options.each = true;
        else if (!std::strcmp(argv[i], "--facets"))
            options.facets = options.each = true;
        else
            options.meshes.push_back(argv[i]);
    }
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = read_options(argc, argv);
    std::map<std::string, std::pair<Sums, std::array<double, 3>>> by_deflection;
    for (const std::string& file : options.meshes) {
        const Sums sums = compare(file, options);
        if (options.each)
            std::printf("%-40s %.3f %.3f false %.1f\n", file.substr(file.rfind('/') + 1).c_str(),
                        sums.recall(), sums.precision(), sums.drawn - sums.right);
        const std::size_t dot = file.rfind('.');
        auto& [all, means] = by_deflection[file.substr(file.find('_', file.rfind('/')),
                                                       dot - file.find('_', file.rfind('/')))];
        all.add(sums);
        means[0] += sums.recall();
        means[1] += sums.precision();
        ++means[2];
    }
    std::puts("deflection      recall precision   mean of parts   false mm");
    for (const auto& [name, entry] : by_deflection)
        std::printf("%-15s %.4f %.4f    %.4f %.4f   %.1f\n", name.c_str(), entry.first.recall(),
                    entry.first.precision(), entry.second[0] / entry.second[2],
                    entry.second[1] / entry.second[2], entry.first.drawn - entry.first.right);
}
