// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "line_drawing/sheet.h"
#include "line_drawing/sheet_options.h"
#include "line_drawing/words.h"

namespace line_drawing {

struct SheetFormat {
    const char* ending;  ///< of files, in lower case
    std::string (*write)(const Sheet& sheet, double dpi);
    bool has_any_letter;       ///< up to U+FFFF in DXF: text is shown in the reader's font
    bool has_tapered_strokes;  ///< DXF readers draw even widths
};
extern const std::array<SheetFormat, 4> kSheetFormats;

/// ".svg, .pdf, .dxf or .png", of all formats.
std::string list_of_endings(const char* between, const char* last);

/// By the extension. @throws laplacian_lines::Error(InvalidOption) if it is unknown
const SheetFormat& format_of(const std::string& file);

/// The bytes of such a file at true scale, PNG at `dpi` dots per inch; no date, so equal sheets
/// give equal bytes. @throws laplacian_lines::Error(InvalidOption) as format_of(), and if the
/// picture would be too large, with what to do instead
std::string write_sheet(const Sheet& sheet, const std::string& file, double dpi = 300);

/// Checks, before the work begins, whether the format has the letters of title and source.
/// @returns a remark if letters of the source become boxes
/// @throws laplacian_lines::Error(InvalidOption) if the title's do, with what to do instead
std::vector<std::string> check_texts(const SheetOptions& options, const std::string& file);

struct SourceMesh {
    std::string name;    ///< of its file, without folders
    std::string sha256;  ///< of its bytes, in hexadecimal; empty: not known
};

/// What a sheet was made of, for the metadata of its file: this version, the meshes and the
/// command's options as given, if any. One line of ASCII without <, > and &, so that any format
/// takes it.
std::string provenance_text(const std::vector<SourceMesh>& meshes,
                            const std::optional<Words>& options = {});

/// The provenance in a file's bytes, and the bytes that follow; empty if there is none.
std::string provenance_in(std::string bytes);

/// Whether a file's bytes have a provenance, and it is not provenance_text(meshes) of any version.
bool is_of_other_meshes(const std::string& bytes, const std::vector<SourceMesh>& meshes);

}  // namespace line_drawing
