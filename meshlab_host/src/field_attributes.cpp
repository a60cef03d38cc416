// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/field_attributes.h"

#include <QStringList>

#include "attributes.h"
#include "field_store.h"

namespace meshlab_host {

using laplacian_lines::Field;
using laplacian_lines::FieldAttribute;
using laplacian_lines::FieldColumn;

namespace {

static_assert(laplacian_lines::field_columns.size() <= 32, "FieldRecord::columns has a bit a row");

const FieldStore& store() {
    static const FieldStore all(
        ColumnList(laplacian_lines::field_columns.begin(), laplacian_lines::field_columns.end()));
    return all;
}

}  // namespace

const char* describe(FieldStatus status) {
    switch (status) {
        case FieldStatus::Stale:
            return " has changed since its attributes were computed";
        case FieldStatus::WrongType:
            return " has attributes of another kind under the names of ours";
        default:
            return "";
    }
}

QString fieldAttributeNames(const Field& field) {
    QStringList names;
    for (const FieldColumn& column : laplacian_lines::present_columns(field))
        for (const FieldAttribute& attribute : column.attributes)
            if (attribute.floats > 0) names << attribute.name;
    return names.join(", ");
}

std::optional<FieldRecord> readFieldRecord(const CMeshO& mesh) {
    const auto* record = findMeshValue<FieldRecord>(mesh, record_attribute);
    if (!record || record->layout != FieldRecord::current_layout) return std::nullopt;
    return *record;
}

FieldStatus fieldStatus(const CMeshO& mesh, const GeometryStamp& now) {
    return store().status(mesh, now);
}

std::optional<Field> readField(const CMeshO& mesh, const GeometryStamp& now) {
    Field field;
    if (!store().read(mesh, now, field)) return std::nullopt;
    return field;
}

void writeField(CMeshO& mesh, const Field& field, const laplacian_lines::PrecomputeOptions& options,
                const GeometryStamp& stamp) {
    store().write(mesh, field, options, stamp);
}

}  // namespace meshlab_host
