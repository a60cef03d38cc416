// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/field_attributes.h"

#include <QStringList>
#include <algorithm>

#include "attributes.h"
#include "hash.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/field_columns.h"
#include "meshlab_host/mesh_conversion.h"

namespace meshlab_host {

using laplacian_lines::Field;
using laplacian_lines::FieldAttribute;
using laplacian_lines::FieldColumn;
using laplacian_lines::kFieldColumns;

namespace {

constexpr const char* record_attribute = "ll_record";
static_assert(kFieldColumns.size() <= 32, "FieldRecord::columns has a bit a row");

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
void visit_attributes(const Columns& columns, Visit visit) {
    for (const FieldColumn& column : columns) {
        int first = 0;
        for (const FieldAttribute& attribute : column.attributes) {
            if (attribute.floats == 3) visit(column, attribute, first, Stored<Point3m>());
            if (attribute.floats == 1) visit(column, attribute, first, Stored<Scalarm>());
            first += attribute.floats;
        }
    }
}

Columns recorded_columns(const FieldRecord& record) {
    Columns columns;
    for (std::size_t i = 0; i < kFieldColumns.size(); ++i)
        if (record.columns >> i & 1u) columns.push_back(kFieldColumns[i]);
    return columns;
}

/// Slots of the vertices that are not deleted, in order. Found once: vertices are much larger than
/// their attributes.
std::vector<std::uint32_t> live_slots(const CMeshO& mesh) {
    std::vector<std::uint32_t> slot_of;
    slot_of.reserve(std::size_t(mesh.vn));
    for (std::size_t slot = 0; slot < mesh.vert.size(); ++slot)
        if (!mesh.vert[slot].IsD()) slot_of.push_back(std::uint32_t(slot));
    return slot_of;
}

/// Whether all are there, with their types and a value per slot.
FieldStatus status_of_names(const CMeshO& mesh, const Columns& columns) {
    FieldStatus status = FieldStatus::Current;
    visit_attributes(columns, [&](const FieldColumn&, const FieldAttribute& attribute, int,
                                  auto stored) {
        using Value = typename decltype(stored)::Value;
        if (!find_attribute(mesh.vert_attr, attribute.name))
            status = FieldStatus::Missing;
        else if (status == FieldStatus::Current && !find_vertex_values<Value>(mesh, attribute.name))
            status = FieldStatus::WrongType;
    });
    return status;
}

/// Of live vertices.
std::uint64_t content_hash(const CMeshO& mesh, const Columns& columns) {
    const std::vector<std::uint32_t> slot_of = live_slots(mesh);
    Hash hash(3);
    visit_attributes(columns,
                     [&](const FieldColumn&, const FieldAttribute& attribute, int, auto stored) {
                         using Value = typename decltype(stored)::Value;
                         const auto& values = *find_vertex_values<Value>(mesh, attribute.name);
                         for (const std::uint32_t slot : slot_of)
                             hash.add(stored.word(values[slot]));
                     });
    return hash.value();
}

void write_columns(CMeshO& mesh, const Columns& columns, const Field& field) {
    const std::vector<std::uint32_t> slot_of = live_slots(mesh);
    visit_attributes(columns, [&](const FieldColumn& column, const FieldAttribute& attribute,
                                  int first, auto stored) {
        using Value = typename decltype(stored)::Value;
        auto& values = ensure_vertex_values<Value>(mesh, attribute.name);
        const float zero[3] = {};
        if (has_deleted_vertices(mesh)) std::fill(values.begin(), values.end(), stored.from(zero));
        const float* floats = column.read(field) + first;
        for (std::size_t live = 0; live < slot_of.size(); ++live)
            values[slot_of[live]] = stored.from(floats + live * std::size_t(column.floats));
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

QString field_attribute_names(const Field& field) {
    QStringList names;
    for (const FieldColumn& column : laplacian_lines::present_columns(field))
        for (const FieldAttribute& attribute : column.attributes)
            if (attribute.floats > 0) names << attribute.name;
    return names.join(", ");
}

std::optional<FieldRecord> read_field_record(const CMeshO& mesh) {
    const auto* record = find_mesh_value<FieldRecord>(mesh, record_attribute);
    if (!record || record->layout != FieldRecord::current_layout) return std::nullopt;
    return *record;
}

FieldStatus field_status(const CMeshO& mesh, const GeometryStamp& now) {
    if (!find_attribute(mesh.mesh_attr, record_attribute)) return FieldStatus::Missing;
    const std::optional<FieldRecord> record = read_field_record(mesh);
    if (!record) return FieldStatus::WrongType;
    const Columns columns = recorded_columns(*record);
    const FieldStatus status = status_of_names(mesh, columns);
    if (status != FieldStatus::Current) return status;
    if (record->stamp != now) return FieldStatus::Stale;
    return content_hash(mesh, columns) == record->content ? FieldStatus::Current
                                                          : FieldStatus::Missing;
}

std::optional<Field> read_field(const CMeshO& mesh, const GeometryStamp& now) {
    if (field_status(mesh, now) != FieldStatus::Current) return std::nullopt;
    const FieldRecord record = *read_field_record(mesh);
    const Columns columns = recorded_columns(record);
    const std::vector<std::uint32_t> slot_of = live_slots(mesh);
    Field field;
    for (const FieldColumn& column : columns)
        column.resize(field, slot_of.size());
    visit_attributes(columns, [&](const FieldColumn& column, const FieldAttribute& attribute,
                                  int first, auto stored) {
        using Value = typename decltype(stored)::Value;
        const auto& values = *find_vertex_values<Value>(mesh, attribute.name);
        float* floats = column.write(field) + first;
        for (std::size_t live = 0; live < slot_of.size(); ++live)
            stored.to(values[slot_of[live]], floats + live * std::size_t(column.floats));
    });
    field.scale = record.scale;
    field.report = record.report;
    return field;
}

void write_field(CMeshO& mesh, const Field& field,
                 const laplacian_lines::PrecomputeOptions& options, const GeometryStamp& stamp) {
    if (!laplacian_lines::has_entries(field, std::size_t(mesh.vn)))
        laplacian_lines::refuse(
            "The mesh changed while its lines were being computed. Run the filter again.",
            laplacian_lines::ErrorCode::FieldMismatch);
    remove_mesh_value(mesh, record_attribute);
    FieldRecord record;
    for (std::size_t i = 0; i < kFieldColumns.size(); ++i)
        record.columns |= std::uint32_t(is_present(kFieldColumns[i], field)) << i;
    const Columns columns = recorded_columns(record);
    for (const FieldColumn& column : kFieldColumns)
        if (!is_present(column, field))
            for (const FieldAttribute& attribute : column.attributes)
                if (attribute.floats > 0) remove_vertex_attribute(mesh, attribute.name);
    write_columns(mesh, columns, field);
    record.stamp = stamp;
    record.content = content_hash(mesh, columns);
    record.options = options;
    record.scale = field.scale;
    record.report = field.report;
    set_mesh_value(mesh, record_attribute, record);
}

}  // namespace meshlab_host
