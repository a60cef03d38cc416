// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "line_drawing/words.h"

namespace line_drawing {

struct SourceMesh {
    std::string name;    ///< of its file, without folders
    std::string sha256;  ///< of its bytes, in hexadecimal; empty: not known
};

/// What a sheet was made of, for the metadata of its file: this version, the meshes and the
/// command's options as given, if any. One line of ASCII without <, > and &, so that any format
/// takes it.
std::string provenanceText(const std::vector<SourceMesh>& meshes,
                           const std::optional<Words>& options = {});

/// How the text begins.
inline constexpr const char* provenance_begin = "{\"laplacian_lines\":";

}  // namespace line_drawing
