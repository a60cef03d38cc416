// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>
#include <optional>
#include <vector>

namespace line_drawing {

/// What a sheet was made of, for who finds it: its file has it as metadata.
struct Provenance {
    struct Mesh {
        QString name;       ///< of its file, without folders
        QByteArray sha256;  ///< of its bytes, in hexadecimal; empty: not known
    };

    QString version;  ///< of Laplacian Lines
    std::vector<Mesh> meshes;
    std::optional<QStringList> options;  ///< of the command, as they were given; none: another way
};

/// By this version. A line of ASCII without <, > and &: what any format takes as it is.
QString provenanceText(const std::vector<Provenance::Mesh>& meshes,
                       const std::optional<QStringList>& options = {});

/// That of a sheet's SVG, PDF or DXF file.
/// @throws laplacian_lines::Error(InvalidOption) if it cannot be read or has none.
Provenance provenanceOf(const QString& file);

}  // namespace line_drawing
