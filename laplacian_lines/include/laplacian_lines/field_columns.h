// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "laplacian_lines/error.h"
#include "laplacian_lines/field.h"

namespace laplacian_lines {

/// A named part of a column: programs that store a field only know scalars and 3-vectors.
struct FieldAttribute {
    const char* name = nullptr;  ///< in files and scripts, stable between versions
    int floats = 0;              ///< 3 or 1; 0 where a column has fewer attributes than it may have
};

/// A column is a vector of Field with some floats per vertex. Texts are UTF-8, without markup.
struct FieldColumn {
    const char* key;                           ///< the name of the vector
    const char* help;                          ///< what it holds, within a sentence
    const char* unit;                          ///< empty if it has none
    int floats;                                ///< per vertex
    std::array<FieldAttribute, 2> attributes;  ///< which hold the floats in their order
    bool optional;                             ///< may be absent: a vector without entries

    std::size_t (*size)(const Field&);  ///< entries
    /// Keeps existing values; new ones are unspecified.
    void (*resize)(Field&, std::size_t entries);
    /// size · floats of them, entry by entry, valid until the vector is resized.
    const float* (*read)(const Field&);
    float* (*write)(Field&);
};

/// The row of a vector of Field whose entries are floats without gaps.
template <auto Member>
constexpr FieldColumn field_column(const char* key, const char* help, const char* unit,
                                   std::array<FieldAttribute, 2> attributes,
                                   bool optional = false) {
    using Entry = typename std::decay_t<decltype(std::declval<Field&>().*Member)>::value_type;
    static_assert(sizeof(Entry) % sizeof(float) == 0);
    return {
        key,
        help,
        unit,
        int(sizeof(Entry) / sizeof(float)),
        attributes,
        optional,
        [](const Field& field) { return (field.*Member).size(); },
        [](Field& field, std::size_t entries) { (field.*Member).resize(entries); },
        [](const Field& field) { return reinterpret_cast<const float*>((field.*Member).data()); },
        [](Field& field) { return reinterpret_cast<float*>((field.*Member).data()); }};
}

/// One row per column; attributes and all checks of sizes come from it, and a test compares the
/// documentation. Files and scripts know columns by the names of their attributes, meshlab_host's
/// record, in memory, by row: another order needs another FieldRecord::current_layout.
inline constexpr std::array kFieldColumns = {
    field_column<&Field::normals>("normals", "unit normal n, smoothed, outward", "",
                                  {{{"ll_normal", 3}}}),
    field_column<&Field::laplacian_normals>("laplacian_normals", "its Laplacian Δn", "1/length²",
                                            {{{"ll_laplacian_normal", 3}}}),
    field_column<&Field::shape_operators>(
        "shape_operators",
        "S = dn, the derivative of the normal along the surface: (xx, yy, zz) and (yz, xz, xy)",
        "1/length", {{{"ll_shape_diagonal", 3}, {"ll_shape_off_diagonal", 3}}}),
    field_column<&Field::smooth_curvatures>(
        "smooth_curvatures",
        "S̄, the shape operator smoothed with the kernel: (uu, uv, vv) in the tangent frame",
        "1/length", {{{"ll_smooth_curvature", 3}}}, true),
    field_column<&Field::curvature_derivatives>(
        "curvature_derivatives",
        "C = ∇S, the derivative of S along the surface: (uuu, uuv, uvv) and vvv in the tangent "
        "frame",
        "1/length²", {{{"ll_curvature_derivative", 3}, {"ll_curvature_derivative_vvv", 1}}}, true),
};

inline bool is_present(const FieldColumn& column, const Field& field) {
    return !column.optional || column.size(field) > 0;
}

inline std::vector<FieldColumn> present_columns(const Field& field) {
    std::vector<FieldColumn> present;
    for (const FieldColumn& column : kFieldColumns)
        if (is_present(column, field)) present.push_back(column);
    return present;
}

[[noreturn]] inline void refuse_field() {
    refuse("The Laplacian lines field belongs to another mesh; compute it again.",
           ErrorCode::FieldMismatch);
}

/// Whether every column that is present or required has this many entries.
inline bool has_entries(const Field& field, std::size_t vertices) {
    for (const FieldColumn& column : kFieldColumns)
        if (is_present(column, field) && column.size(field) != vertices) return false;
    return true;
}

}  // namespace laplacian_lines
