// SPDX-License-Identifier: GPL-3.0-or-later
#include "column_attributes.h"

#include <algorithm>

#include "attributes.h"
#include "hash.h"
#include "meshlab_host/mesh_conversion.h"

namespace meshlab_host {

using laplacian_lines::Field;
using laplacian_lines::FieldAttribute;
using laplacian_lines::FieldColumn;

namespace {

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

/// Calls visit(column, attribute, number of its first float, Stored<its type>()).
template <class Visit>
void visitAttributes(const ColumnList& columns, Visit visit) {
    for (const FieldColumn& column : columns) {
        int first = 0;
        for (const FieldAttribute& attribute : column.attributes) {
            if (attribute.floats == 3) visit(column, attribute, first, Stored<Point3m>());
            if (attribute.floats == 1) visit(column, attribute, first, Stored<Scalarm>());
            first += attribute.floats;
        }
    }
}

/// Not deleted. Attributes are read one by one, the much larger vertices at most once.
class LiveVertices {
public:
    explicit LiveVertices(const CMeshO& mesh)
        : all_(!hasDeletedVertices(mesh)), count_(std::size_t(mesh.vn)) {
        if (all_) return;
        slots_.reserve(count_);
        for (std::size_t slot = 0; slot < mesh.vert.size(); ++slot)
            if (!mesh.vert[slot].IsD()) slots_.push_back(std::uint32_t(slot));
    }

    bool all() const { return all_; }

    template <class Visit>
    void visit(Visit visit) const {
        for (std::size_t live = 0; live < count_; ++live)
            visit(all_ ? live : slots_[live], live);
    }

private:
    bool all_;  ///< none is deleted; then there are no slots
    std::size_t count_;
    std::vector<std::uint32_t> slots_;
};

}  // namespace

bool hasNames(const CMeshO& mesh, const ColumnList& columns) {
    bool all = true;
    visitAttributes(columns, [&](const FieldColumn&, const FieldAttribute& attribute, int, auto) {
        all = all && hasVertexAttribute(mesh, attribute.name);
    });
    return all;
}

bool hasColumns(const CMeshO& mesh, const ColumnList& columns) {
    bool all = true;
    visitAttributes(columns,
                    [&](const FieldColumn&, const FieldAttribute& attribute, int, auto stored) {
                        using Value = typename decltype(stored)::Value;
                        all = all && findVertexValues<Value>(mesh, attribute.name);
                    });
    return all;
}

std::uint64_t contentHash(const CMeshO& mesh, const ColumnList& columns) {
    const LiveVertices vertices(mesh);
    Hash hash(3);
    visitAttributes(columns,
                    [&](const FieldColumn&, const FieldAttribute& attribute, int, auto stored) {
                        using Value = typename decltype(stored)::Value;
                        const auto& values = *findVertexValues<Value>(mesh, attribute.name);
                        vertices.visit([&](std::size_t slot, std::size_t) {
                            hash.add(decltype(stored)::word(values[slot]));
                        });
                    });
    return hash.value();
}

void readColumns(const CMeshO& mesh, const ColumnList& columns, Field& field) {
    const LiveVertices vertices(mesh);
    for (const FieldColumn& column : columns)
        column.resize(field, std::size_t(mesh.vn));
    visitAttributes(columns, [&](const FieldColumn& column, const FieldAttribute& attribute,
                                 int first, auto stored) {
        using Value = typename decltype(stored)::Value;
        const auto& values = *findVertexValues<Value>(mesh, attribute.name);
        float* floats = column.write(field) + first;
        vertices.visit([&](std::size_t slot, std::size_t live) {
            decltype(stored)::to(values[slot], floats + live * std::size_t(column.floats));
        });
    });
}

void writeColumns(CMeshO& mesh, const ColumnList& columns, const Field& field) {
    const LiveVertices vertices(mesh);
    visitAttributes(columns,
                    [&](const FieldColumn&, const FieldAttribute& attribute, int, auto stored) {
                        using Value = typename decltype(stored)::Value;
                        demandVertexValues<Value>(mesh, attribute.name);
                    });
    visitAttributes(columns, [&](const FieldColumn& column, const FieldAttribute& attribute,
                                 int first, auto stored) {
        using Value = typename decltype(stored)::Value;
        auto& values = demandVertexValues<Value>(mesh, attribute.name);
        const float zero[3] = {};
        if (!vertices.all()) std::fill(values.begin(), values.end(), decltype(stored)::from(zero));
        const float* floats = column.read(field) + first;
        vertices.visit([&](std::size_t slot, std::size_t live) {
            values[slot] = decltype(stored)::from(floats + live * std::size_t(column.floats));
        });
    });
}

void removeColumns(CMeshO& mesh, const ColumnList& columns) {
    visitAttributes(columns, [&](const FieldColumn&, const FieldAttribute& attribute, int, auto) {
        removeVertexAttribute(mesh, attribute.name);
    });
}

}  // namespace meshlab_host
