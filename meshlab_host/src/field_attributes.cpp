// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/field_attributes.h"

#include <QStringList>
#include <algorithm>
#include <numeric>

#include "attributes.h"
#include "hash.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/field_columns.h"
#include "meshlab_host/mesh_conversion.h"

namespace meshlab_host {

using laplacian_lines::Field;
using laplacian_lines::field_columns;
using laplacian_lines::FieldAttribute;
using laplacian_lines::FieldColumn;

namespace {

constexpr const char* record_attribute = "ll_record";
static_assert(field_columns.size() <= 32, "FieldRecord::columns has a bit a row");

/// Conversion between floats and attribute values.
template <class Value>
struct Stored;
template <>
struct Stored<Point3m> {
    using Value = Point3m;
    static Point3m from(const float* floats) { return {floats[0], floats[1], floats[2]}; }
    static void to(const Point3m& value, float* floats) {
        for (int axis = 0; axis < 3; ++axis)
            floats[axis] = float(value[axis]);
    }
    static std::uint64_t word(const Point3m& value) { return pack(value); }
};
template <>
struct Stored<Scalarm> {
    using Value = Scalarm;
    static Scalarm from(const float* floats) { return *floats; }
    static void to(Scalarm value, float* floats) { *floats = float(value); }
    static std::uint64_t word(Scalarm value) { return bits(value); }
};

using Columns = std::vector<FieldColumn>;

/// Calls visit(column, attribute, number of its first float, Stored<its type>()).
template <class Visit>
void visitAttributes(const Columns& columns, Visit visit) {
    for (const FieldColumn& column : columns) {
        int first = 0;
        for (const FieldAttribute& attribute : column.attributes) {
            if (attribute.floats == 3) visit(column, attribute, first, Stored<Point3m>());
            if (attribute.floats == 1) visit(column, attribute, first, Stored<Scalarm>());
            first += attribute.floats;
        }
    }
}

Columns recordedColumns(const FieldRecord& record) {
    Columns columns;
    for (std::size_t i = 0; i < field_columns.size(); ++i)
        if (record.columns >> i & 1u) columns.push_back(field_columns[i]);
    return columns;
}

/// By live index (see mesh_conversion.h). Attributes are read one by one, the much larger vertices
/// at most once.
std::vector<std::uint32_t> liveSlots(const CMeshO& mesh) {
    std::vector<std::uint32_t> live_slots(std::size_t(mesh.vn), 0);
    if (!hasDeletedVertices(mesh)) {
        std::iota(live_slots.begin(), live_slots.end(), 0u);
        return live_slots;
    }
    auto next = live_slots.begin();
    for (std::size_t slot = 0; slot < mesh.vert.size(); ++slot)
        if (!mesh.vert[slot].IsD()) *next++ = std::uint32_t(slot);
    return live_slots;
}

/// Whether all are there, with their types and a value per slot.
FieldStatus statusOfNames(const CMeshO& mesh, const Columns& columns) {
    FieldStatus status = FieldStatus::Current;
    visitAttributes(columns, [&](const FieldColumn&, const FieldAttribute& attribute, int,
                                 auto stored) {
        using Value = typename decltype(stored)::Value;
        if (!hasVertexAttribute(mesh, attribute.name))
            status = FieldStatus::Missing;
        else if (status == FieldStatus::Current && !findVertexValues<Value>(mesh, attribute.name))
            status = FieldStatus::WrongType;
    });
    return status;
}

/// Of live vertices.
std::uint64_t contentHash(const CMeshO& mesh, const Columns& columns) {
    const std::vector<std::uint32_t> live_slots = liveSlots(mesh);
    Hash hash(3);
    visitAttributes(columns,
                    [&](const FieldColumn&, const FieldAttribute& attribute, int, auto stored) {
                        using Value = typename decltype(stored)::Value;
                        const auto& values = *findVertexValues<Value>(mesh, attribute.name);
                        for (const std::uint32_t slot : live_slots)
                            hash.add(stored.word(values[slot]));
                    });
    return hash.value();
}

void writeColumns(CMeshO& mesh, const Columns& columns, const Field& field) {
    const std::vector<std::uint32_t> live_slots = liveSlots(mesh);
    const auto demandValues = [&](const FieldAttribute& attribute, auto stored) -> auto& {
        return demandVertexValues<typename decltype(stored)::Value>(mesh, attribute.name);
    };
    visitAttributes(columns, [&](const FieldColumn&, const FieldAttribute& attribute, int,
                                 auto stored) { demandValues(attribute, stored); });
    visitAttributes(columns, [&](const FieldColumn& column, const FieldAttribute& attribute,
                                 int first, auto stored) {
        auto& values = demandValues(attribute, stored);
        const float zero[3] = {};
        if (hasDeletedVertices(mesh)) std::fill(values.begin(), values.end(), stored.from(zero));
        const float* floats = column.read(field) + first;
        for (std::size_t live = 0; live < live_slots.size(); ++live)
            values[live_slots[live]] = stored.from(floats + live * std::size_t(column.floats));
    });
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
    if (!findAttribute(mesh.mesh_attr, record_attribute)) return FieldStatus::Missing;
    const std::optional<FieldRecord> record = readFieldRecord(mesh);
    if (!record) return FieldStatus::WrongType;
    const Columns columns = recordedColumns(*record);
    const FieldStatus status = statusOfNames(mesh, columns);
    if (status != FieldStatus::Current) return status;
    if (record->stamp != now) return FieldStatus::Stale;
    return contentHash(mesh, columns) == record->content ? FieldStatus::Current
                                                         : FieldStatus::Missing;
}

std::optional<Field> readField(const CMeshO& mesh, const GeometryStamp& now) {
    if (fieldStatus(mesh, now) != FieldStatus::Current) return std::nullopt;
    const FieldRecord record = *readFieldRecord(mesh);
    const Columns columns = recordedColumns(record);
    const std::vector<std::uint32_t> live_slots = liveSlots(mesh);
    Field field;
    for (const FieldColumn& column : columns)
        column.resize(field, live_slots.size());
    visitAttributes(columns, [&](const FieldColumn& column, const FieldAttribute& attribute,
                                 int first, auto stored) {
        using Value = typename decltype(stored)::Value;
        const auto& values = *findVertexValues<Value>(mesh, attribute.name);
        float* floats = column.write(field) + first;
        for (std::size_t live = 0; live < live_slots.size(); ++live)
            stored.to(values[live_slots[live]], floats + live * std::size_t(column.floats));
    });
    field.scale = record.scale;
    field.report = record.report;
    return field;
}

void writeField(CMeshO& mesh, const Field& field, const laplacian_lines::PrecomputeOptions& options,
                const GeometryStamp& stamp) {
    if (!laplacian_lines::has_entries(field, std::size_t(mesh.vn)))
        throw laplacian_lines::Error(laplacian_lines::ErrorCode::FieldMismatch,
                                     "The mesh changed while its lines were being computed. "
                                     "Run the filter again.");
    removeMeshValue(mesh, record_attribute);
    FieldRecord record;
    for (std::size_t i = 0; i < field_columns.size(); ++i)
        record.columns |= std::uint32_t(is_present(field_columns[i], field)) << i;
    const Columns columns = recordedColumns(record);
    for (const FieldColumn& column : field_columns)
        if (!is_present(column, field))
            for (const FieldAttribute& attribute : column.attributes)
                if (attribute.floats > 0) removeVertexAttribute(mesh, attribute.name);
    writeColumns(mesh, columns, field);
    record.stamp = stamp;
    record.content = contentHash(mesh, columns);
    record.options = options;
    record.scale = field.scale;
    record.report = field.report;
    setMeshValue(mesh, record_attribute, record);
}

}  // namespace meshlab_host
