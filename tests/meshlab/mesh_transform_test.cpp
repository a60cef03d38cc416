// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes, fields and layers as they stand in the world.
#include "world_layers.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "add_layer.h"
#include "generators.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/precompute.h"
#include "meshlab_host/field_attributes.h"
#include "meshlab_host/field_source.h"
#include "meshlab_host/mesh_conversion.h"
#include "meshlab_host/mesh_transform.h"

namespace {

using laplacian_lines::Field;
using laplacian_lines::TriangleMesh;
using meshlab_host::apply_transform;

Eigen::Matrix4d moved(const Eigen::Matrix3d& linear) {
    Eigen::Matrix4d layer = Eigen::Matrix4d::Identity();
    layer.topLeftCorner<3, 3>() = linear;
    layer.topRightCorner<3, 1>() = Eigen::Vector3d(5, -6, 7);
    return layer;
}

Eigen::Matrix3d turned() {
    return Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
}

double volume_of(const TriangleMesh& mesh) {
    double volume = 0;
    for (const auto& t : mesh.triangles)
        volume += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
    return volume;
}

/// The largest difference, in shares of the largest vector.
template <class Vectors>
double difference(const Vectors& a, const Vectors& b) {
    EXPECT_EQ(a.size(), b.size());
    double largest = 0, most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, double((a[i] - b[i]).norm()));
        most = std::max(most, double(b[i].norm()));
    }
    return largest / most;
}

TEST(MeshTransform, OnlyMovesTurnsAndSizesAreSimilarities) {
    EXPECT_TRUE(meshlab_host::similarity_of(moved(turned())));
    const std::optional<meshlab_host::Similarity> twice =
        meshlab_host::similarity_of(moved(2 * turned()));
    ASSERT_TRUE(twice);
    EXPECT_NEAR(twice->factor, 2, 1e-12);
    EXPECT_TRUE(twice->rotation.isApprox(turned(), 1e-12));
    EXPECT_FALSE(meshlab_host::similarity_of(moved(Eigen::Vector3d(1, 1, 1.01).asDiagonal())));
    EXPECT_FALSE(meshlab_host::similarity_of(moved(Eigen::Vector3d(1, 1, -1).asDiagonal())));
    EXPECT_FALSE(meshlab_host::similarity_of(moved(Eigen::Matrix3d::Zero())));
    EXPECT_FALSE(meshlab_host::similarity_of(moved(Eigen::Matrix3d::Constant(std::nan("")))));
}

TEST(MeshTransform, ItsFieldIsTheOneComputedThere) {
    TriangleMesh mesh = test_meshes::bumpy_sphere(4).mesh;
    laplacian_lines::PrecomputeOptions options;
    options.curvature_derivatives = true;
    Field field = laplacian_lines::precompute(mesh, options);
    const Eigen::Matrix4d layer = moved(3 * turned());
    apply_transform(layer, mesh);
    apply_transform(*meshlab_host::similarity_of(layer), field);
    EXPECT_TRUE(field.curvature_derivatives.empty());
    laplacian_lines::add_curvature_derivatives(mesh, field);
    const Field expected = laplacian_lines::precompute(mesh, options);
    EXPECT_LT(difference(field.normals, expected.normals), 1e-3);
    EXPECT_LT(difference(field.laplacian_normals, expected.laplacian_normals), 1e-2);
    EXPECT_NEAR(field.scale.diagonal, expected.scale.diagonal, 0.1 * expected.scale.diagonal);
    EXPECT_NEAR(field.scale.mean_edge, expected.scale.mean_edge, 1e-4 * expected.scale.mean_edge);
    EXPECT_NEAR(field.scale.kernel_size, expected.scale.kernel_size,
                1e-3 * expected.scale.kernel_size);
    EXPECT_LT(difference(field.curvature_derivatives, expected.curvature_derivatives), 1e-2);
    double largest = 0, most = 0;
    for (std::size_t i = 0; i < field.shape_operators.size(); ++i)
        for (const Eigen::Vector3f& v : {Eigen::Vector3f(1, 0, 0), Eigen::Vector3f(0, 1, 1)}) {
            const Eigen::Vector3f there = expected.shape_operators[i] * v;
            largest = std::max(largest, double((field.shape_operators[i] * v - there).norm()));
            most = std::max(most, double(there.norm()));
        }
    EXPECT_LT(largest / most, 1e-2);
}

void write_own_field(CMeshO& mesh) {
    const Field field = laplacian_lines::precompute(meshlab_host::to_triangle_mesh(mesh));
    meshlab_host::write_field(mesh, field, {}, meshlab_host::geometry_stamp(mesh));
}

TEST(WorldLayers, AreMovedWithTheirFields) {
    MeshDocument document;
    CMeshO& mesh = add_layer(document, "sphere", test_meshes::bumpy_sphere(3).mesh);
    write_own_field(mesh);
    const RichParameterList list;
    meshlab_host::FilterResults results;
    const auto placed = [&] {
        WorldLayers layers = copy_layers(
            {false, false}, {document, list, nullptr, [](const QString&) {}, results}, 1);
        EXPECT_TRUE(layers.at(0).field);
        return layers.at(0);
    };
    WorldLayer expected = placed();
    const Eigen::Matrix4d layer = moved(3 * turned());
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            mesh.Tr[row][column] = Scalarm(layer(row, column));
    const WorldLayer there = placed();
    EXPECT_GT(difference(there.mesh.positions, expected.mesh.positions), 0.5);
    apply_transform(layer, expected.mesh);
    apply_transform(*meshlab_host::similarity_of(layer), *expected.field);
    EXPECT_LT(difference(there.mesh.positions, expected.mesh.positions), 1e-5);
    EXPECT_LT(difference(there.field->normals, expected.field->normals), 1e-5);
    EXPECT_LT(difference(there.field->laplacian_normals, expected.field->laplacian_normals), 1e-5);
}

/// Undone and cut in four again, it has as many triangles as before, with other vertices.
TEST(FieldSource, ASubdividedMeshIsDrawnWithAFieldOfItsOwn) {
    MeshDocument document;
    CMeshO& mesh =
        add_layer(document, "sphere", test_meshes::subdivided(test_meshes::bumpy_sphere(6).mesh));
    write_own_field(mesh);
    const TriangleMesh drawn = meshlab_host::to_drawn_mesh(mesh);
    ASSERT_EQ(drawn.triangles.size(), std::size_t(mesh.fn));
    ASSERT_GT(drawn.positions.size(), std::size_t(mesh.vn));
    const Field field = meshlab_host::find_or_compute_field(
        mesh, drawn, "sphere", meshlab_host::field_source(mesh), [](const QString&) {});
    EXPECT_EQ(field.normals.size(), drawn.positions.size());
}

TEST(MeshTransform, FacesKeepTheirOutside) {
    for (const double side : {1., -1.}) {
        TriangleMesh mesh = test_meshes::bumpy_sphere(3).mesh;
        const double before = volume_of(mesh);
        apply_transform(moved(Eigen::Vector3d(1, 2, side).asDiagonal()), mesh);
        EXPECT_NEAR(volume_of(mesh), 2 * before, 1e-6 * before);
    }
}

TEST(MeshTransform, FlatTransformationsAreRefused) {
    TriangleMesh mesh = test_meshes::bumpy_sphere(2).mesh;
    EXPECT_THROW(apply_transform(moved(Eigen::Vector3d(1, 1, 0).asDiagonal()), mesh),
                 laplacian_lines::Error);
    EXPECT_THROW(apply_transform(moved(Eigen::Matrix3d::Constant(std::nan(""))), mesh),
                 laplacian_lines::Error);
}

}  // namespace
