// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "line_drawing/words.h"

namespace line_drawing {

/// A mesh that a sheet was made of.
struct SourceMesh {
    std::string name;    ///< of its file, without folders
    std::string sha256;  ///< of its bytes, in hexadecimal; empty: not known
};

/// What a sheet was made of, for who finds it, as the metadata of its file: by this version, with
/// these options of the command, as they were given; none: another way. A line of ASCII without
/// <, > and &: what any format takes as it is.
std::string provenanceText(const std::vector<SourceMesh>& meshes,
                           const std::optional<Words>& options = {});

/// With what the text begins.
inline constexpr const char* provenance_begin = "{\"laplacian_lines\":";

}  // namespace line_drawing
