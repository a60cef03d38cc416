// SPDX-License-Identifier: GPL-3.0-or-later
// The candidates of ridges and valleys against the plain ones of plain_ridges.h: the same pieces in
// the same triangles, joined to the same lines.
#include "plain_ridges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "fixed/ridge_candidates.h"
#include "flaked_stone.h"
#include "generators.h"
#include "laplacian_lines/precompute.h"
#include "laplacian_lines/tangent_frame.h"
#include "mesh/prepared_mesh.h"
#include "mesh_noise.h"
#include "registry.h"

namespace {

using namespace laplacian_lines;
using reference::Edge;
using reference::RidgeEnd;
using reference::RidgeLine;
using reference::RidgePiece;

constexpr double kPlaceError = 1e-6;  // D
constexpr double kBendError = 1e-5;   // of the bend
constexpr double kLengthError = 1e-4;

/// A mesh with what the fast code finds in it.
class Found {
public:
    Found(const TriangleMesh& mesh, Field field)
        : mesh_(mesh),
          field_(std::move(field)),
          data_(build_extractor_data(mesh, field_)),
          numbers_(prepare_geometry(mesh, Cuts::Left).original_vertex),
          placed_(place_clusters(data_)) {}

    const Field& field() const { return field_; }
    std::vector<RidgePiece> plain(Crest crest) const {
        return reference::ridge_pieces(mesh_, field_, crest.kind);
    }

    /// By the sorted vertices of their triangles, of which a mesh may have several.
    std::multimap<Triangle, ZeroPiece> pieces(Crest crest) const {
        std::multimap<Triangle, ZeroPiece> found;
        for (const ZeroPieces& of_cluster : find_ridge_pieces(placed_, crest))
            for (const ZeroPiece& piece : of_cluster) {
                Triangle triangle;
                for (unsigned k = 0; k < 3; ++k)
                    triangle[k] = corner(piece.ends[0].form.side, k);
                std::sort(triangle.begin(), triangle.end());
                found.emplace(triangle, piece);
            }
        return found;
    }

    /// The edges that each line crosses, and its length.
    std::vector<std::pair<std::set<Edge>, float>> lines(Crest crest) const {
        const RidgeCandidates found = find_ridge_candidates(data_, placed_, crest);
        std::vector<std::pair<std::set<Edge>, float>> lines;
        for (const Polyline& line : found.lines.lines) {
            lines.push_back({{}, line.length});
            for (std::uint32_t i = 0; i < line.count; ++i) {
                const MeshSide& side = found.forms[line.first + i].side;
                lines.back().first.insert(
                    std::minmax(corner(side, side.side), corner(side, (side.side + 1u) % 3)));
            }
        }
        return lines;
    }

    Edge edge_of(const Zero& zero) const {
        return {numbers_[zero.edge >> 32], numbers_[zero.edge & 0xffffffffu]};
    }

    Eigen::Vector3d to_mesh(const Eigen::Vector3f& local) const {
        return data_.centre + data_.diagonal * local.cast<double>();
    }

private:
    std::uint32_t corner(const MeshSide& side, unsigned k) const {
        const PlacedCluster& cluster = placed_[side.cluster];
        return numbers_[cluster.vertices[cluster.triangle(side.triangle).corners[k]]];
    }

    const TriangleMesh& mesh_;
    const Field field_;
    const ExtractorData data_;
    const std::vector<std::uint32_t> numbers_;  // in the mesh, of what is left of a dirty one
    const std::vector<PlacedCluster> placed_;
};

struct Count {
    int compared = 0, uncertain = 0, lines = 0;
};

bool is_same(const RidgeEnd& plain, const Zero& fast, const Found& found,
             const TriangleMesh& mesh) {
    const Edge& edge = plain.edge;
    const double length = (mesh.positions[edge.first] - mesh.positions[edge.second]).norm();
    const Eigen::Vector3d bend = fast.form.bend.cast<double>();
    return found.edge_of(fast) == edge &&
           (found.to_mesh(fast.form.position) - plain.position).norm() <=
               kPlaceError * found.field().scale.diagonal + plain.blur * length &&
           std::min((bend - plain.bend).norm(), (bend + plain.bend).norm()) <=
               kBendError * plain.bend.norm() + plain.blur * plain.bend_change;
}

bool is_same(const RidgePiece& plain, const ZeroPiece& fast, const Found& found,
             const TriangleMesh& mesh) {
    const auto ends = [&](int first) {
        return is_same(plain.ends[0], fast.ends[first], found, mesh) &&
               is_same(plain.ends[1], fast.ends[1 - first], found, mesh);
    };
    return ends(0) || ends(1);
}

/// Whether rounding leaves both ends about where they are.
bool is_placed(const RidgePiece& piece) {
    return std::max(piece.ends[0].blur, piece.ends[1].blur) <= 0.01;
}

void compare_pieces(const TriangleMesh& mesh, const Found& found, Crest crest, Count& count) {
    std::multimap<Triangle, ZeroPiece> fast = found.pieces(crest);
    for (const RidgePiece& plain : found.plain(crest)) {
        const auto there = fast.find(plain.triangle);
        if (plain.is_certain) {
            ++(is_placed(plain) ? count.compared : count.uncertain);
            if (there == fast.end())
                ADD_FAILURE() << "missing at " << plain.ends[0].position.transpose();
            else
                EXPECT_TRUE(is_same(plain, there->second, found, mesh))
                    << "another piece at " << plain.ends[0].position.transpose();
        } else {
            ++count.uncertain;
        }
        if (there != fast.end()) fast.erase(there);
    }
    for (const auto& [triangle, piece] : fast)
        ADD_FAILURE() << "one too many at "
                      << found.to_mesh(piece.ends[0].form.position).transpose();
}

/// Whether more than a quarter of it is in pieces longer than 6 % of D.
bool is_guessed(const RidgeLine& line, double diagonal) {
    double guessed = 0;
    for (const double piece : line.pieces)
        if (piece > 0.06 * diagonal) guessed += piece;
    return guessed > line.length / 4;
}

void compare_lines(const Found& found, Crest crest, Count& count) {
    const double diagonal = found.field().scale.diagonal;
    const double least = kLeastRidgeLength / 3 * diagonal;  // however sharp
    std::map<std::set<Edge>, double> fast;
    for (const auto& [edges, length] : found.lines(crest))
        fast[edges] = length * diagonal;
    for (const RidgeLine& plain : reference::join_ridges(found.plain(crest))) {
        const auto there = fast.find(plain.edges);
        const bool is_about_least = std::abs(plain.length - least) <= kLengthError * least;
        if (there == fast.end()) {
            EXPECT_TRUE(!plain.is_certain || is_about_least || plain.length < least ||
                        is_guessed(plain, diagonal))
                << "missing: a line of " << plain.edges.size() << " points";
            continue;
        }
        EXPECT_TRUE(plain.length >= least || is_about_least);
        EXPECT_FALSE(is_guessed(plain, diagonal));
        if (plain.is_certain) {
            EXPECT_NEAR(there->second, plain.length, kLengthError * plain.length);
            ++count.lines;
        }
        fast.erase(there);
    }
    std::set<Edge> doubtful;
    for (const RidgePiece& piece : found.plain(crest)) {
        const Triangle& t = piece.triangle;
        if (!piece.is_certain) doubtful.insert({{t[0], t[1]}, {t[1], t[2]}, {t[0], t[2]}});
    }
    for (const auto& [edges, length] : fast)
        EXPECT_TRUE(std::any_of(edges.begin(), edges.end(),
                                [&](const Edge& edge) { return doubtful.count(edge) > 0; }))
            << "one too many: a line of " << edges.size() << " points";
}

Count compare(const TriangleMesh& mesh, Field field) {
    const Found found(mesh, std::move(field));
    Count count;
    for (const Crest crest : {kConvexCrest, kConcaveCrest}) {
        compare_pieces(mesh, found, crest, count);
        compare_lines(found, crest, count);
    }
    return count;
}

Count compare(const TriangleMesh& mesh) {
    return compare(mesh, precompute(mesh));
}

class PlainRidges : public testing::TestWithParam<const test_meshes::MeshEntry*> {};

INSTANTIATE_TEST_SUITE_P(Meshes, PlainRidges, testing::ValuesIn(test_meshes::meshes_with(0)),
                         [](const auto& info) { return info.param->name; });

/// Crests of regular meshes pass exactly through vertices, where rounding decides; a little
/// noise ends that.
TEST_P(PlainRidges, AreThePiecesOfAPlainLoop) {
    const TriangleMesh& mesh = GetParam()->get().mesh;
    compare(mesh);
    for (const double noise : {0.02, 0.2}) {
        const Count count = compare(mesh_noise::with_noise(mesh, noise));
        EXPECT_LE(count.uncertain, 2 + count.compared / 20) << noise;
    }
}

/// Forms that have many; those of a form are the valleys of the same as a cavity.
TEST(PlainRidgesOfForms, AreThePiecesOfAPlainLoop) {
    const TriangleMesh meshes[] = {
        test_meshes::bumpy_sphere(5, 0.15).mesh, test_meshes::torus(80, 40, 0.2).mesh,
        test_meshes::ellipsoid(4, 0.2).mesh, test_meshes::FlakedStone({}).mesh(4),
        test_meshes::rounded_cube(40, 0.15)};
    for (const TriangleMesh& mesh : meshes) {
        const TriangleMesh noisy = mesh_noise::with_noise(mesh, 0.1);
        for (const bool is_cavity : {false, true}) {
            const Count count = compare(is_cavity ? test_meshes::cavity(noisy) : noisy);
            EXPECT_GT(count.compared, 120);
            EXPECT_GT(count.lines, 5);
            EXPECT_LE(count.uncertain, count.compared / 100);
        }
    }
}

/// Directions that turn by any angle in a triangle, as they do on no smooth surface.
TEST(PlainRidgesOfForms, AreThePiecesOfAPlainLoopWhateverTheField) {
    const TriangleMesh mesh = test_meshes::torus(80, 40, 0.2).mesh;
    Field field = precompute(mesh);
    const double diagonal = field.scale.diagonal;
    std::mt19937 random(1);
    const auto number = [&] { return float(mesh_noise::signed_unit(random)); };
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const TangentFrame frame = tangent_frame(field.normals[v]);
        const float angle = 3.2f * number();
        const Eigen::Vector3f e = std::cos(angle) * frame.u + std::sin(angle) * frame.v;
        const float k = (number() > 0 ? 20.f : -20.f) / float(diagonal);
        field.shape_operators[v] = {k * e.x() * e.x(), k * e.y() * e.y(), k * e.z() * e.z(),
                                    k * e.y() * e.z(), k * e.x() * e.z(), k * e.x() * e.y()};
        field.laplacian_normals[v] = {number(), number(), number()};
    }
    const Count count = compare(mesh, field);
    EXPECT_GT(count.compared, 300);
    EXPECT_LE(count.uncertain, count.compared / 20);
}

}  // namespace
