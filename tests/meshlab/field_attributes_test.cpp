// SPDX-License-Identifier: GPL-3.0-or-later
// Fields as attributes of a mesh.
#include "meshlab_host/field_attributes.h"

#include <gtest/gtest.h>

#include "laplacian_lines/error.h"
#include "laplacian_lines/field_columns.h"
#include "meshlab_host/meshlab_api.h"

namespace {

using namespace laplacian_lines;
using namespace meshlab_host;
using Allocator = vcg::tri::Allocator<CMeshO>;

/// All floats differ.
Field numbered(std::size_t vertices) {
    Field field;
    float next = 1;
    for (const FieldColumn& column : kFieldColumns) {
        column.resize(field, vertices);
        for (std::size_t i = 0; i < vertices * std::size_t(column.floats); ++i)
            column.write(field)[i] = next++;
    }
    field.scale.diagonal = 7;
    field.report.triangles = 1;
    return field;
}

class FieldAttributes : public testing::Test {
protected:
    /// Five vertices, the second deleted.
    FieldAttributes() {
        auto vertex = Allocator::AddVertices(mesh, 5);
        for (int i = 0; i < 5; ++i, ++vertex)
            vertex->P() = Point3m(Scalarm(i), Scalarm(i * i), 0);
        Allocator::AddFace(mesh, 0, 2, 3);
        Allocator::DeleteVertex(mesh, mesh.vert[1]);
    }

    void write() { write_field(mesh, field, {}, geometry_stamp(mesh)); }
    FieldStatus status() const { return field_status(mesh, geometry_stamp(mesh)); }
    template <class Value>
    Value& value_of(const char* name, std::size_t slot) {
        auto handle = Allocator::FindPerVertexAttribute<Value>(mesh, std::string(name));
        EXPECT_TRUE(Allocator::IsValidHandle(mesh, handle)) << name;
        return handle[slot];
    }

    CMeshO mesh;
    Field field = numbered(4);
};

TEST_F(FieldAttributes, ComeBack) {
    EXPECT_EQ(status(), FieldStatus::Missing);
    PrecomputeOptions options;
    options.kernel_size = 3;
    write_field(mesh, field, options, geometry_stamp(mesh));
    EXPECT_EQ(status(), FieldStatus::Current);
    EXPECT_EQ(read_field_record(mesh)->options.kernel_size, 3);
    const auto back = read_field(mesh, geometry_stamp(mesh));
    ASSERT_TRUE(back);
    for (const FieldColumn& column : kFieldColumns) {
        ASSERT_EQ(column.size(*back), column.size(field)) << column.key;
        const std::size_t count = column.size(field) * std::size_t(column.floats);
        EXPECT_TRUE(std::equal(column.read(field), column.read(field) + count, column.read(*back)))
            << column.key;
    }
    EXPECT_EQ(back->scale.diagonal, 7);
    EXPECT_EQ(back->report.triangles, 1u);
    EXPECT_EQ(value_of<Point3m>("ll_normal", 0), Point3m(1, 2, 3));
    EXPECT_EQ(value_of<Point3m>("ll_normal", 1), Point3m(0, 0, 0)) << "of a deleted vertex";
    EXPECT_EQ(value_of<Point3m>("ll_normal", 2), Point3m(4, 5, 6));
}

TEST_F(FieldAttributes, BelongToCoordinatesAndCorners) {
    const GeometryStamp stamp = geometry_stamp(mesh);
    for (const bool is_compact : {false, true}) {
        if (is_compact) Allocator::CompactEveryVector(mesh);
        EXPECT_EQ(geometry_stamp(mesh), stamp);
        mesh.vert.back().P()[1] += 1;
        EXPECT_NE(geometry_stamp(mesh), stamp);
        mesh.vert.back().P()[1] -= 1;
        std::swap(mesh.face[0].V(0), mesh.face[0].V(1));
        EXPECT_NE(geometry_stamp(mesh), stamp);
        std::swap(mesh.face[0].V(0), mesh.face[0].V(1));
    }
    write();
    mesh.vert[0].P()[0] += 1;
    EXPECT_EQ(status(), FieldStatus::Stale);
}

TEST_F(FieldAttributes, OfEarlierFieldsAreRemoved) {
    write();
    EXPECT_TRUE(vcg::tri::HasPerVertexAttribute(mesh, "ll_curvature_derivative"));
    field.curvature_derivatives.clear();
    write();
    EXPECT_FALSE(vcg::tri::HasPerVertexAttribute(mesh, "ll_curvature_derivative"));
    EXPECT_EQ(status(), FieldStatus::Current);
}

TEST_F(FieldAttributes, CountOnlyWithEveryValueOfTheirNamesAndTypes) {
    for (const FieldColumn& column : kFieldColumns)
        for (const FieldAttribute& attribute : column.attributes) {
            if (attribute.floats == 0) continue;
            write();
            if (attribute.floats == 3) value_of<Point3m>(attribute.name, 3)[1] += 1;
            if (attribute.floats == 1) value_of<Scalarm>(attribute.name, 3) += 1;
            EXPECT_EQ(status(), FieldStatus::Missing) << attribute.name;
            EXPECT_FALSE(read_field(mesh, geometry_stamp(mesh))) << attribute.name;
            write();
            Allocator::DeletePerVertexAttribute(mesh, std::string(attribute.name));
            EXPECT_EQ(status(), FieldStatus::Missing) << attribute.name;
            Allocator::AddPerVertexAttribute<char>(mesh, std::string(attribute.name));
            EXPECT_EQ(status(), FieldStatus::WrongType) << attribute.name;
        }
}

TEST_F(FieldAttributes, EveryColumnHasToFitTheMesh) {
    for (const FieldColumn& column : kFieldColumns) {
        field = numbered(4);
        column.resize(field, 3);
        EXPECT_THROW(write(), Error) << column.key;
        EXPECT_TRUE(mesh.vert_attr.empty()) << column.key;
    }
}

}  // namespace
