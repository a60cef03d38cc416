// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace reference {

using namespace laplacian_lines;

bool has_area(const TriangleMesh& mesh, const Triangle& t) {
    const auto& p = mesh.positions;
    for (std::uint32_t v : t)
        if (!p[v].allFinite()) return false;
    return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm() > 0;
}

Values evaluate(const TriangleMesh& mesh, const Field& field, const View& view) {
    Values values;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Eigen::Vector3d& p = mesh.positions[v];
        const Eigen::Vector3d l =
            p.allFinite() ? Eigen::Vector3d(view.eye - view.w * p) : Eigen::Vector3d::Zero();
        values.illumination.push_back(field.normals[v].cast<double>().dot(l));
        values.laplacian.push_back(field.laplacian_normals[v].cast<double>().dot(l));
    }
    return values;
}

std::vector<Piece> pieces(const TriangleMesh& mesh, const std::vector<double>& values) {
    std::vector<Piece> result;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (!has_area(mesh, t)) continue;
        Piece piece{i, {}, {}};
        int found = 0;
        for (int k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
            if ((values[a] < 0) == (values[b] < 0)) continue;
            const double fa = std::abs(values[a]), fb = std::abs(values[b]);
            piece.edges[std::size_t(found)] = {a, b};
            piece.ends[std::size_t(found)] =
                (fb * mesh.positions[a] + fa * mesh.positions[b]) / (fa + fb);
            ++found;
        }
        if (found == 2) result.push_back(piece);
    }
    return result;
}

std::vector<Chain> chains(const std::vector<Piece>& pieces) {
    std::map<Piece::Edge, std::vector<std::size_t>> at_edge;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (const Piece::Edge& edge : pieces[i].edges)
            at_edge[edge].push_back(i);
    std::vector<bool> visited(pieces.size(), false);
    // Follows a piece over one of its edges for as long as it goes on; true if it comes round.
    const auto walk = [&](std::size_t start, int side, std::size_t& count) {
        std::size_t piece = start;
        Piece::Edge edge = pieces[start].edges[std::size_t(side)];
        for (;;) {
            const auto& here = at_edge[edge];
            if (here.size() != 2) return false;
            piece = here[0] == piece ? here[1] : here[0];
            if (piece == start) return true;
            visited[piece] = true;
            ++count;
            const auto& edges = pieces[piece].edges;
            edge = edges[0] == edge ? edges[1] : edges[0];
        }
    };
    std::vector<Chain> result;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (visited[i]) continue;
        visited[i] = true;
        Chain chain{1, false};
        chain.closed = walk(i, 0, chain.pieces);
        if (!chain.closed) walk(i, 1, chain.pieces);
        result.push_back(chain);
    }
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<Chain> chains(const LineSet& lines) {
    std::vector<Chain> result;
    for (const Polyline& line : lines.lines)
        result.push_back({line.count - 1, line.closed});
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace reference
