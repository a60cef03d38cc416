// SPDX-License-Identifier: GPL-3.0-or-later
// Fields as attributes, by the core's table of columns and by one with another column.
#include "meshlab_host/field_attributes.h"

#include <gtest/gtest.h>

#include "attributes.h"
#include "field_store.h"
#include "laplacian_lines/error.h"

namespace {

using namespace laplacian_lines;
using namespace meshlab_host;

/// With a vector and a number that the core does not have.
struct RicherField : Field {
    std::vector<Eigen::Vector4f> colors;
};

ColumnList coreTable() {
    return {field_columns.begin(), field_columns.end()};
}

ColumnList richerTable() {
    ColumnList table = coreTable();
    table.push_back(field_column<&RicherField::colors>(
        "colors", "for nothing", "", {{{"ll_hue", 3}, {"ll_light", 1}}}, ColumnPresence::Optional));
    return table;
}

/// All floats differ.
template <class AnyField>
AnyField numbered(const ColumnList& columns, std::size_t vertices) {
    AnyField field;
    float next = 1;
    for (const FieldColumn& column : columns) {
        column.resize(field, vertices);
        for (std::size_t i = 0; i < vertices * std::size_t(column.floats); ++i)
            column.write(field)[i] = next++;
    }
    field.scale.diagonal = 7;
    field.report.triangles = 1;
    return field;
}

template <class Value>
Value& valueOf(CMeshO& mesh, const char* name, std::size_t slot) {
    return demandVertexValues<Value>(mesh, name)[slot];
}

class FieldAttributes : public testing::Test {
protected:
    /// Five vertices, the second deleted.
    FieldAttributes() {
        auto vertex = vcg::tri::Allocator<CMeshO>::AddVertices(mesh, 5);
        for (int i = 0; i < 5; ++i, ++vertex)
            vertex->P() = Point3m(Scalarm(i), Scalarm(i * i), 0);
        vcg::tri::Allocator<CMeshO>::AddFace(mesh, 0, 2, 3);
        vcg::tri::Allocator<CMeshO>::DeleteVertex(mesh, mesh.vert[1]);
    }

    void write(const RicherField& field) { store.write(mesh, field, {}, geometryStamp(mesh)); }
    FieldStatus status() const { return store.status(mesh, geometryStamp(mesh)); }

    CMeshO mesh;
    const FieldStore store{richerTable()};
    const RicherField richer = numbered<RicherField>(richerTable(), 4);
    const RicherField plain = numbered<RicherField>(coreTable(), 4);
};

void expectSame(const Field& a, const Field& b, const ColumnList& columns) {
    for (const FieldColumn& column : columns) {
        ASSERT_EQ(column.size(a), column.size(b)) << column.key;
        const std::size_t count = column.size(a) * std::size_t(column.floats);
        EXPECT_TRUE(std::equal(column.read(a), column.read(a) + count, column.read(b)))
            << column.key;
    }
    EXPECT_EQ(a.scale.diagonal, b.scale.diagonal);
    EXPECT_EQ(a.report.triangles, b.report.triangles);
}

TEST_F(FieldAttributes, ComeBack) {
    EXPECT_EQ(fieldStatus(mesh, geometryStamp(mesh)), FieldStatus::Missing);
    const Field field = numbered<Field>(coreTable(), 4);
    PrecomputeOptions options;
    options.kernel_size = 3;
    writeField(mesh, field, options, geometryStamp(mesh));
    EXPECT_EQ(fieldStatus(mesh, geometryStamp(mesh)), FieldStatus::Current);
    EXPECT_EQ(readFieldRecord(mesh)->options.kernel_size, 3);
    EXPECT_EQ(readFieldRecord(mesh)->options.normal_sigma, 0) << "automatic, whatever was chosen";
    const auto back = readField(mesh, geometryStamp(mesh));
    ASSERT_TRUE(back);
    expectSame(*back, field, coreTable());
    EXPECT_EQ(valueOf<Point3m>(mesh, "ll_normal", 0), Point3m(1, 2, 3));
    EXPECT_EQ(valueOf<Point3m>(mesh, "ll_normal", 2), Point3m(4, 5, 6));
    EXPECT_EQ(valueOf<Point3m>(mesh, "ll_shape_off_diagonal", 0), Point3m(28, 29, 30));
    EXPECT_EQ(valueOf<Scalarm>(mesh, "ll_kernel_size", 4), 52);
    EXPECT_EQ(mesh.vert_attr.size(), 8u);
}

TEST_F(FieldAttributes, BelongToCoordinatesAndCorners) {
    const GeometryStamp stamp = geometryStamp(mesh);
    for (const bool is_compact : {false, true}) {
        if (is_compact) vcg::tri::Allocator<CMeshO>::CompactEveryVector(mesh);
        EXPECT_EQ(geometryStamp(mesh), stamp);
        mesh.vert.back().P()[1] += 1;
        EXPECT_NE(geometryStamp(mesh), stamp);
        mesh.vert.back().P()[1] -= 1;
        std::swap(mesh.face[0].V(0), mesh.face[0].V(1));
        EXPECT_NE(geometryStamp(mesh), stamp);
        std::swap(mesh.face[0].V(0), mesh.face[0].V(1));
    }
}

TEST_F(FieldAttributes, OfDeletedVerticesAreZero) {
    valueOf<Point3m>(mesh, "ll_normal", 1) = Point3m(1, 1, 1);
    write(richer);
    EXPECT_EQ(valueOf<Point3m>(mesh, "ll_normal", 1), Point3m(0, 0, 0));
    EXPECT_EQ(valueOf<Scalarm>(mesh, "ll_light", 1), 0);
}

TEST_F(FieldAttributes, FollowTheTable) {
    write(richer);
    EXPECT_EQ(status(), FieldStatus::Current);
    EXPECT_EQ(valueOf<Point3m>(mesh, "ll_hue", 0), Point3m(81, 82, 83));
    EXPECT_EQ(valueOf<Scalarm>(mesh, "ll_light", 0), 84);
    EXPECT_EQ(valueOf<Point3m>(mesh, "ll_hue", 2), Point3m(85, 86, 87));
    RicherField back;
    ASSERT_TRUE(store.read(mesh, geometryStamp(mesh), back));
    expectSame(back, richer, richerTable());
}

TEST_F(FieldAttributes, OfAbsentColumnsAreNeitherWrittenNorAskedFor) {
    write(plain);
    EXPECT_EQ(status(), FieldStatus::Current);
    EXPECT_FALSE(hasVertexAttribute(mesh, "ll_hue"));
    EXPECT_FALSE(hasVertexAttribute(mesh, "ll_light"));
    RicherField back;
    ASSERT_TRUE(store.read(mesh, geometryStamp(mesh), back));
    expectSame(back, plain, richerTable());
    EXPECT_TRUE(back.colors.empty());
    valueOf<Scalarm>(mesh, "ll_hue", 0) = 1;  // somebody else's
    EXPECT_EQ(status(), FieldStatus::Current);
}

TEST_F(FieldAttributes, OfEarlierFieldsAreRemoved) {
    write(richer);
    write(plain);
    EXPECT_FALSE(hasVertexAttribute(mesh, "ll_hue"));
    EXPECT_FALSE(hasVertexAttribute(mesh, "ll_light"));
    EXPECT_EQ(status(), FieldStatus::Current);
    write(richer);
    EXPECT_EQ(status(), FieldStatus::Current);
    EXPECT_EQ(valueOf<Scalarm>(mesh, "ll_light", 4), 96);
}

TEST_F(FieldAttributes, CountOnlyWithEveryValue) {
    for (const FieldColumn& column : richerTable())
        for (const FieldAttribute& attribute : column.attributes) {
            write(richer);
            ASSERT_EQ(status(), FieldStatus::Current);
            if (attribute.floats == 3) valueOf<Point3m>(mesh, attribute.name, 3)[1] += 1;
            if (attribute.floats == 1) valueOf<Scalarm>(mesh, attribute.name, 3) += 1;
            EXPECT_EQ(status(), attribute.floats == 0 ? FieldStatus::Current : FieldStatus::Missing)
                << column.key;
            RicherField back;
            EXPECT_EQ(store.read(mesh, geometryStamp(mesh), back), attribute.floats == 0);
        }
}

TEST_F(FieldAttributes, CountOnlyWithTheirNamesAndTypes) {
    for (const FieldColumn& column : richerTable())
        for (const FieldAttribute& attribute : column.attributes) {
            if (attribute.floats == 0) continue;
            write(richer);
            removeVertexAttribute(mesh, attribute.name);
            EXPECT_EQ(status(), FieldStatus::Missing) << attribute.name;
            demandVertexValues<char>(mesh, attribute.name);
            EXPECT_EQ(status(), FieldStatus::WrongType) << attribute.name;
        }
    write(richer);
    mesh.vert[0].P()[0] += 1;
    EXPECT_EQ(status(), FieldStatus::Stale);
}

TEST_F(FieldAttributes, EveryColumnHasToFitTheMesh) {
    for (const FieldColumn& column : richerTable()) {
        RicherField field = richer;
        column.resize(field, 3);
        EXPECT_THROW(write(field), Error) << column.key;
        EXPECT_TRUE(mesh.vert_attr.empty()) << column.key;
    }
}

TEST_F(FieldAttributes, AreNamedInTheLog) {
    const std::string always =
        "ll_normal, ll_laplacian_normal, ll_shape_diagonal, ll_shape_off_diagonal, ll_kernel_size";
    EXPECT_EQ(
        fieldAttributeNames(plain).toStdString(),
        always + ", ll_smooth_curvature, ll_curvature_derivative, ll_curvature_derivative_vvv");
    Field usual = plain;
    usual.smooth_curvatures.clear();
    usual.curvature_derivatives.clear();
    EXPECT_EQ(fieldAttributeNames(usual).toStdString(), always);
}

}  // namespace
