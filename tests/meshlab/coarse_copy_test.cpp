// SPDX-License-Identifier: GPL-3.0-or-later
// What dialogs learn about large meshes without looking at all of them.
#include "compute_filter.h"

#include <gtest/gtest.h>

#include "add_layer.h"
#include "filters.h"
#include "generators.h"
#include "laplacian_lines/option_table.h"
#include "laplacian_lines/precompute.h"
#include "line_drawing/object.h"
#include "meshlab_host/field_attributes.h"
#include "meshlab_host/mesh_conversion.h"
#include "meshlab_host/parameters.h"

namespace {

/// Somewhat more than a million triangles, narrower around x = 0.
laplacian_lines::TriangleMesh largeBox() {
    laplacian_lines::TriangleMesh mesh = test_meshes::cube(300);
    for (Eigen::Vector3d& p : mesh.positions)
        p.x() *= 0.2 + p.x() * p.x();
    return mesh;
}

struct LargeBox {
    MeshDocument document;
    CMeshO& mesh = addLayer(document, "box", largeBox());

    RichParameterList defaults() const {
        RichParameterList list;
        ComputeFilter().listParameters(document.mm(), list);
        return list;
    }
    double defaultKernel() const {
        return *meshlab_host::defaultOf(defaults().getParameterByName("kernel_size"));
    }
    /// The filter's record of it.
    double kernelAfter(const RichParameterList& list) {
        meshlab_host::FilterResults results;
        ComputeFilter().run({document, list, nullptr, [](const QString&) {}, results});
        return meshlab_host::readFieldRecord(mesh)->options.kernel_size;
    }
};

TEST(CoarseCopy, IsAsLargeAsTheMeshAndHasItsMeanEdge) {
    const LargeBox scene;
    const auto copy = coarseCopy(scene.mesh);
    ASSERT_TRUE(copy);
    EXPECT_LT(copy->positions.size(), scene.mesh.vert.size() / 2);
    const laplacian_lines::TriangleMesh whole = meshlab_host::toTriangleMesh(scene.mesh);
    const Eigen::AlignedBox3d box = line_drawing::boundsOf(whole);
    EXPECT_EQ(line_drawing::boundsOf(*copy).min(), box.min());
    EXPECT_EQ(line_drawing::boundsOf(*copy).max(), box.max());
    const double mean_edge = laplacian_lines::measure_scale(whole).mean_edge;
    EXPECT_NEAR(laplacian_lines::measure_scale(*copy).mean_edge, mean_edge, 0.003 * mean_edge);
}

TEST(CoarseCopy, LeavesOutWhatIsDeleted) {
    LargeBox scene;
    for (CFaceO& face : scene.mesh.face)
        if (face.cP(0)[2] > 0 && scene.mesh.fn > most_faces_looked_at + 1000)
            vcg::tri::Allocator<CMeshO>::DeleteFace(scene.mesh, face);
    const auto copy = coarseCopy(scene.mesh);
    ASSERT_TRUE(copy);
    EXPECT_LT(copy->triangles.size(), 65000u);
}

TEST(CoarseCopy, IsNoneOfSmallMeshesAndOfThoseWithVerticesFarOff) {
    LargeBox scene;
    const auto stray = vcg::tri::Allocator<CMeshO>::AddVertices(scene.mesh, 2);
    stray[0].P() = Point3m(std::nanf(""), 0, 0);
    stray[1].P() = Point3m(0, 0, 0);
    EXPECT_TRUE(coarseCopy(scene.mesh));
    scene.mesh.vert.back().P() = Point3m(0, 0, 10);
    EXPECT_FALSE(coarseCopy(scene.mesh));
    scene.mesh.vert.back().P() = Point3m(0, 0, 0);
    while (scene.mesh.fn > most_faces_looked_at)
        vcg::tri::Allocator<CMeshO>::DeleteFace(scene.mesh,
                                                scene.mesh.face[std::size_t(scene.mesh.fn - 1)]);
    EXPECT_FALSE(coarseCopy(scene.mesh));
}

TEST(ComputeDialog, ShowsTheAutomaticKernelOfLargeMeshes) {
    LargeBox scene;
    const double kernel =
        laplacian_lines::measure_scale(meshlab_host::toTriangleMesh(scene.mesh)).kernel_size;
    EXPECT_NEAR(scene.defaultKernel(), kernel, 0.003 * kernel);
}

TEST(ComputeDialog, LeftAsItIsTakesTheAutomaticKernelOfTheWholeMesh) {
    LargeBox scene;
    EXPECT_EQ(scene.kernelAfter(scene.defaults()), 0);
    laplacian_lines::PrecomputeOptions options;
    options.kernel_size = 1.01 * scene.defaultKernel();
    RichParameterList list;
    meshlab_host::addParameters(laplacian_lines::precompute_option_table(), options, 1, "", list);
    EXPECT_NEAR(scene.kernelAfter(list), options.kernel_size, 1e-6);
}

}  // namespace
