// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/field_attributes.h"

#include "attribute_names.h"
#include "attributes.h"
#include "hash.h"
#include "laplacian_lines/error.h"
#include "meshlab_host/mesh_conversion.h"

namespace meshlab_host {

using laplacian_lines::Field;

namespace {

struct Columns {
    const std::vector<Point3m>* normals;
    const std::vector<Point3m>* laplacian_normals;
    const std::vector<Point3m>* shape_diagonals;
    const std::vector<Point3m>* shape_off_diagonals;
    const std::vector<Scalarm>* kernel_sizes;

    bool complete() const {
        return normals && laplacian_normals && shape_diagonals && shape_off_diagonals &&
               kernel_sizes;
    }
};

Columns findColumns(const CMeshO& mesh) {
    return {findVertexColumn<Point3m>(mesh, normal_attribute),
            findVertexColumn<Point3m>(mesh, laplacian_normal_attribute),
            findVertexColumn<Point3m>(mesh, shape_diagonal_attribute),
            findVertexColumn<Point3m>(mesh, shape_off_diagonal_attribute),
            findVertexColumn<Scalarm>(mesh, kernel_size_attribute)};
}

/// Of the values of all vertices that are not deleted.
std::uint64_t contentHash(const CMeshO& mesh, const Columns& columns) {
    Hash hash(3);
    for (std::size_t slot = 0; slot < mesh.vert.size(); ++slot) {
        if (mesh.vert[slot].IsD()) continue;
        hash.add(pack((*columns.normals)[slot]));
        hash.add(pack((*columns.laplacian_normals)[slot]));
        hash.add(pack((*columns.shape_diagonals)[slot]));
        hash.add(pack((*columns.shape_off_diagonals)[slot]));
        hash.add(bits((*columns.kernel_sizes)[slot]));
    }
    return hash.value();
}

bool allNamesPresent(const CMeshO& mesh) {
    for (const char* name : {normal_attribute, laplacian_normal_attribute, shape_diagonal_attribute,
                             shape_off_diagonal_attribute, kernel_size_attribute})
        if (!hasVertexAttribute(mesh, name)) return false;
    return findAttribute(mesh.mesh_attr, record_attribute) != nullptr;
}

Eigen::Vector3f toEigen(const Point3m& p) {
    return {float(p[0]), float(p[1]), float(p[2])};
}

Point3m toPoint(const Eigen::Vector3f& v) {
    return Point3m(v.x(), v.y(), v.z());
}

void resize(Field& field, std::size_t vertices) {
    field.normals.resize(vertices);
    field.laplacian_normals.resize(vertices);
    field.shape_operators.resize(vertices);
    field.kernel_sizes.resize(vertices);
}

void checkSize(const CMeshO& mesh, const Field& field) {
    const std::size_t vertices = std::size_t(mesh.vn);
    if (field.normals.size() != vertices || field.laplacian_normals.size() != vertices ||
        field.shape_operators.size() != vertices || field.kernel_sizes.size() != vertices)
        throw laplacian_lines::Error(laplacian_lines::ErrorCode::FieldMismatch,
                                     "The mesh changed while its lines were being computed. "
                                     "Run the filter again.");
}

/// Replaces the columns' values. Only making the columns can fail, and that comes first.
void fillColumns(CMeshO& mesh, const Field& field) {
    auto& normals = demandVertexColumn<Point3m>(mesh, normal_attribute);
    auto& laplacians = demandVertexColumn<Point3m>(mesh, laplacian_normal_attribute);
    auto& diagonals = demandVertexColumn<Point3m>(mesh, shape_diagonal_attribute);
    auto& off_diagonals = demandVertexColumn<Point3m>(mesh, shape_off_diagonal_attribute);
    auto& kernel_sizes = demandVertexColumn<Scalarm>(mesh, kernel_size_attribute);

    const Point3m zero(0, 0, 0);
    std::size_t live = 0;
    for (std::size_t slot = 0; slot < mesh.vert.size(); ++slot) {
        if (mesh.vert[slot].IsD()) {
            normals[slot] = laplacians[slot] = diagonals[slot] = off_diagonals[slot] = zero;
            kernel_sizes[slot] = 0;
            continue;
        }
        const laplacian_lines::ShapeOperator& s = field.shape_operators[live];
        normals[slot] = toPoint(field.normals[live]);
        laplacians[slot] = toPoint(field.laplacian_normals[live]);
        diagonals[slot] = Point3m(s.xx, s.yy, s.zz);
        off_diagonals[slot] = Point3m(s.yz, s.xz, s.xy);
        kernel_sizes[slot] = field.kernel_sizes[live];
        ++live;
    }
}

}  // namespace

const char* describe(FieldStatus status) {
    switch (status) {
        case FieldStatus::Current:
            return "precomputed attributes";
        case FieldStatus::Missing:
            return "no precomputed attributes";
        case FieldStatus::Stale:
            return "changed since its attributes were computed";
        case FieldStatus::WrongType:
            return "attributes of another kind under the same names";
    }
    return "";
}

const char* fieldAttributeNames() {
    return "ll_normal, ll_laplacian_normal, ll_shape_diagonal, ll_shape_off_diagonal, "
           "ll_kernel_size";
}

std::optional<FieldRecord> readFieldRecord(const CMeshO& mesh) {
    const auto* record = findMeshValue<FieldRecord>(mesh, record_attribute);
    if (!record || record->layout != FieldRecord::current_layout) return std::nullopt;
    return *record;
}

FieldStatus fieldStatus(const CMeshO& mesh, const GeometryStamp& now) {
    if (!allNamesPresent(mesh)) return FieldStatus::Missing;
    const std::optional<FieldRecord> record = readFieldRecord(mesh);
    const Columns columns = findColumns(mesh);
    if (!record || !columns.complete()) return FieldStatus::WrongType;
    if (record->stamp != now) return FieldStatus::Stale;
    return contentHash(mesh, columns) == record->content ? FieldStatus::Current
                                                         : FieldStatus::Missing;
}

std::optional<Field> readField(const CMeshO& mesh, const GeometryStamp& now) {
    if (fieldStatus(mesh, now) != FieldStatus::Current) return std::nullopt;
    const Columns columns = findColumns(mesh);
    const FieldRecord record = *readFieldRecord(mesh);
    Field field;
    field.scale = record.scale;
    field.report = record.report;
    resize(field, std::size_t(mesh.vn));
    std::size_t live = 0;
    for (std::size_t slot = 0; slot < mesh.vert.size(); ++slot) {
        if (mesh.vert[slot].IsD()) continue;
        const Point3m& d = (*columns.shape_diagonals)[slot];
        const Point3m& o = (*columns.shape_off_diagonals)[slot];
        field.normals[live] = toEigen((*columns.normals)[slot]);
        field.laplacian_normals[live] = toEigen((*columns.laplacian_normals)[slot]);
        field.shape_operators[live] = {float(d[0]), float(d[1]), float(d[2]),
                                       float(o[0]), float(o[1]), float(o[2])};
        field.kernel_sizes[live] = float((*columns.kernel_sizes)[slot]);
        ++live;
    }
    return field;
}

void writeField(CMeshO& mesh, const Field& field, const laplacian_lines::PrecomputeOptions& options,
                const GeometryStamp& stamp) {
    checkSize(mesh, field);
    removeMeshValue(mesh, record_attribute);
    fillColumns(mesh, field);
    FieldRecord record;
    record.stamp = stamp;
    record.content = contentHash(mesh, findColumns(mesh));
    record.options = options;
    record.scale = field.scale;
    record.report = field.report;
    setMeshValue(mesh, record_attribute, record);
}

}  // namespace meshlab_host
