// SPDX-License-Identifier: GPL-3.0-or-later
// What is said about meshes that draw badly, and nothing about others.
#include "laplacian_lines/mesh_faults.h"

#include <gtest/gtest.h>

#include <map>

#include "laplacian_lines/precompute.h"
#include "registry.h"

namespace {

using namespace laplacian_lines;
using namespace test_meshes;
using Faults = std::vector<MeshFault>;

Faults faults_found(const TriangleMesh& mesh, const PrecomputeOptions& options = {}) {
    return faults_of(precompute(mesh, options).report);
}

TriangleMesh flipped(TriangleMesh mesh, int every) {
    flip_triangles(mesh, every);
    return mesh;
}

/// Separate triangles, slightly shrunk.
TriangleMesh shrunk_triangles(const TriangleMesh& whole) {
    TriangleMesh mesh = cut_apart(whole);
    for (const Triangle& t : mesh.triangles) {
        const Eigen::Vector3d centre =
            (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
        for (std::uint32_t v : t)
            mesh.positions[v] += 1e-3 * (centre - mesh.positions[v]);
    }
    return mesh;
}

class EachTestMesh : public testing::TestWithParam<const MeshEntry*> {};

/// By design; all others are sound.
TEST_P(EachTestMesh, HasTheFaultsItIsMadeWith) {
    static const std::map<std::string, Faults> faulty = {
        {"flipped_torus", {MeshFault::Turned}},
        {"triangle_soup", {MeshFault::Torn}},
    };
    const auto known = faulty.find(GetParam()->name);
    const MeshReport report = precompute(GetParam()->get().mesh).report;
    EXPECT_EQ(faults_of(report), known == faulty.end() ? Faults() : known->second)
        << "borders " << report.border_share << ", opposed " << report.opposed_share << ", turned "
        << report.turned_triangles << ", bend " << report.kernel_bend;
}

INSTANTIATE_TEST_SUITE_P(MeshFaults, EachTestMesh, testing::ValuesIn(meshes_with(0)),
                         [](const auto& info) { return info.param->name; });

TEST(MeshFaults, OfSurfacesTurnedInsideOut) {
    for (const char* name : {"sphere", "torus", "bumpy_sphere", "ellipsoid", "rounded_cube"}) {
        const TriangleMesh& mesh = mesh_named(name).mesh;
        EXPECT_EQ(faults_found(flipped(mesh, 1)), Faults{MeshFault::InsideOut}) << name;
    }
    // A hole, as in scans; an open surface has no inside.
    TriangleMesh holed = mesh_named("sphere").mesh;
    holed.triangles.resize(holed.triangles.size() * 98 / 100);
    EXPECT_EQ(faults_found(holed), Faults());
    EXPECT_EQ(faults_found(flipped(holed, 1)), Faults{MeshFault::InsideOut});
    for (const char* name : {"hills", "plane", "half_torus"})
        EXPECT_EQ(faults_found(flipped(mesh_named(name).mesh, 1)), Faults()) << name;
}

TEST(MeshFaults, OfTrianglesTurnedHereAndThere) {
    for (const char* name : {"sphere", "hills"})
        for (int every : {2, 3, 20})
            EXPECT_EQ(faults_found(flipped(mesh_named(name).mesh, every)),
                      Faults{MeshFault::Turned})
                << name << every;
    EXPECT_EQ(faults_found(test_meshes::moebius_strip(60, 8)), Faults());  // one edge across
    EXPECT_EQ(faults_found(flipped(test_meshes::moebius_strip(60, 8), 3)),
              Faults{MeshFault::Disagreeing});
}

TEST(MeshFaults, OfPiecesThatDoNotHangTogether) {
    const TriangleMesh& torus = mesh_named("torus").mesh;
    EXPECT_EQ(faults_found(shrunk_triangles(torus)), Faults{MeshFault::Torn});
    // Cuts that close by themselves.
    EXPECT_EQ(faults_found(cut_apart(torus)), Faults());
    PrecomputeOptions unwelded;
    unwelded.weld_duplicates = false;
    EXPECT_EQ(faults_found(cut_apart(torus), unwelded), Faults{MeshFault::Torn});
}

TEST(MeshFaults, OfKernelsThatBlurTheForm) {
    const TriangleMesh& torus = mesh_named("torus").mesh;
    PrecomputeOptions options;
    options.kernel_size = 0.05;
    EXPECT_EQ(faults_found(torus, options), Faults());
    options.kernel_size = 0.5;
    EXPECT_EQ(faults_found(torus, options), Faults{MeshFault::CoarseKernel});
}

}  // namespace
