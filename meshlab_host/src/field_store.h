// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "column_attributes.h"
#include "meshlab_host/field_attributes.h"

namespace meshlab_host {

constexpr const char* record_attribute = "ll_record";

/// Behind field_attributes.h, for any table of up to 32 columns.
class FieldStore {
public:
    explicit FieldStore(ColumnList table) : table_(std::move(table)) {}

    FieldStatus status(const CMeshO& mesh, const GeometryStamp& now) const;

    /// Returns false and leaves `field` alone unless status() is Current.
    bool read(const CMeshO& mesh, const GeometryStamp& now, laplacian_lines::Field& field) const;

    /// @throws laplacian_lines::Error(FieldMismatch), std::bad_alloc
    void write(CMeshO& mesh, const laplacian_lines::Field& field,
               const laplacian_lines::PrecomputeOptions& options, const GeometryStamp& stamp) const;

private:
    ColumnList recorded(const FieldRecord& record) const;
    ColumnList required() const;

    ColumnList table_;
};

}  // namespace meshlab_host
