// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/triangle_mesh.h"

// Checks what the core guarantees for any input. A violation is the first violated guarantee as
// text, or nothing.
namespace wild {

std::string violation(const laplacian_lines::TriangleMesh& mesh,
                      const laplacian_lines::Field& field);
std::string violation(const laplacian_lines::LineSet& lines);
/// By the lines of a view that are seen and hidden, in space and in the picture.
std::string violation(const laplacian_lines::TriangleMesh& mesh,
                      const laplacian_lines::LineExtractor& extractor,
                      const laplacian_lines::View& view, const laplacian_lines::LineStyle& style);

/// A mesh of up to 255 vertices, options, style and view from bytes, through all of the core, with
/// its own or a made-up field; errors are fine.
std::string violation_of_bytes(const std::uint8_t* bytes, std::size_t size);

/// Bytes of which violation_of_bytes() makes this mesh, or its beginning.
std::vector<std::uint8_t> bytes_of(const laplacian_lines::TriangleMesh& mesh);

}  // namespace wild
