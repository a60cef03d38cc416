// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"
#include "line_drawing/words.h"

namespace line_drawing {

enum class SheetFormat { Svg, Pdf, Dxf, Png };

/// By the extension. @throws laplacian_lines::Error(InvalidOption) if it is unknown
SheetFormat formatOf(const std::string& file);

/// The bytes of a file at true scale, PNG at `dpi` dots per inch; a function of the sheet alone.
/// @throws laplacian_lines::Error(InvalidOption) if the picture would be too large, with what to do
/// instead
std::string writeSheet(const Sheet& sheet, SheetFormat format, double dpi = 300);

/// Whether the format has the letters of title and source, asked before the work begins.
/// @returns a remark if letters of the source become boxes
/// @throws laplacian_lines::Error(InvalidOption) if the title's do, with what to do instead
std::vector<std::string> checkTexts(const SheetOptions& options, SheetFormat format);

/// The strokes that a format can have: DXF readers draw even widths.
StrokeStyle strokesIn(const std::string& file, StrokeStyle wanted);

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
