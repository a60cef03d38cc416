// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_store.h"

#include "attributes.h"
#include "laplacian_lines/error.h"

namespace meshlab_host {

using laplacian_lines::Field;
using laplacian_lines::FieldColumn;

ColumnList FieldStore::recorded(const FieldRecord& record) const {
    ColumnList columns;
    for (std::size_t i = 0; i < table_.size(); ++i)
        if (record.columns >> i & 1u) columns.push_back(table_[i]);
    return columns;
}

ColumnList FieldStore::required() const {
    ColumnList columns;
    for (const FieldColumn& column : table_)
        if (!column.optional) columns.push_back(column);
    return columns;
}

FieldStatus FieldStore::status(const CMeshO& mesh, const GeometryStamp& now) const {
    const std::optional<FieldRecord> record = readFieldRecord(mesh);
    const ColumnList columns = record ? recorded(*record) : required();
    if (!findAttribute(mesh.mesh_attr, record_attribute) || !hasNames(mesh, columns))
        return FieldStatus::Missing;
    if (!record || !hasColumns(mesh, columns)) return FieldStatus::WrongType;
    if (record->stamp != now) return FieldStatus::Stale;
    return contentHash(mesh, columns) == record->content ? FieldStatus::Current
                                                         : FieldStatus::Missing;
}

bool FieldStore::read(const CMeshO& mesh, const GeometryStamp& now, Field& field) const {
    if (status(mesh, now) != FieldStatus::Current) return false;
    const FieldRecord record = *readFieldRecord(mesh);
    readColumns(mesh, recorded(record), field);
    field.scale = record.scale;
    field.report = record.report;
    return true;
}

void FieldStore::write(CMeshO& mesh, const Field& field,
                       const laplacian_lines::PrecomputeOptions& options,
                       const GeometryStamp& stamp) const {
    if (!laplacian_lines::has_entries(field, std::size_t(mesh.vn), table_))
        throw laplacian_lines::Error(laplacian_lines::ErrorCode::FieldMismatch,
                                     "The mesh changed while its lines were being computed. "
                                     "Run the filter again.");
    removeMeshValue(mesh, record_attribute);
    FieldRecord record;
    ColumnList present, absent;
    for (std::size_t i = 0; i < table_.size(); ++i) {
        const bool is_present = laplacian_lines::is_present(table_[i], field);
        (is_present ? present : absent).push_back(table_[i]);
        record.columns |= std::uint32_t(is_present) << i;
    }
    removeColumns(mesh, absent);
    writeColumns(mesh, present, field);
    record.stamp = stamp;
    record.content = contentHash(mesh, present);
    record.options = options;
    record.scale = field.scale;
    record.report = field.report;
    setMeshValue(mesh, record_attribute, record);
}

}  // namespace meshlab_host
