// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/option_table.h"
#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

// MeshLab parameters from tables of options: one per row, named by a prefix and its key. Floats are
// read back as the shortest decimal, so that 0.07 stays 0.07; numbers from Python may be doubles.

/// Help, HTML without paragraphs, so that MeshLab wraps it in a tool tip.
QString tool_tip(const QString& help);

/// `diagonal` of the mesh's bounding box, for percentages of lengths; 0 without a mesh.
void add_parameter(const laplacian_lines::OptionDescription& option,
                   const laplacian_lines::OptionValue& value, RichParameterList& list,
                   double diagonal = 0, const QString& prefix = QString());

/// `fallback` if the list lacks it. @throws laplacian_lines::Error(InvalidOption) that names label,
/// value and what is allowed, unless the value is in the option's range and of its kind; numbers
/// may be of any type of number
laplacian_lines::OptionValue read_parameter(const laplacian_lines::OptionDescription& option,
                                            const laplacian_lines::OptionValue& fallback,
                                            const RichParameterList& list,
                                            const QString& prefix = QString());

/// Keeps the option if the list lacks it. @throws as the above
template <class Options>
void read_parameter(const laplacian_lines::OptionRow<Options>& row, Options& options,
                    const RichParameterList& list, const QString& prefix = QString()) {
    row.set_value(options, read_parameter(row, row.value(options), list, prefix));
}

// Parameter values as people write and read them. Thread-safe.

/// A number; a color, #202020 or its name; on, off, yes, no, true, false; or a choice, its number
/// or an unambiguous beginning, in any case. @throws laplacian_lines::Error(InvalidOption) that
/// names label, text and what is allowed
double number_in(const QString& text, const laplacian_lines::OptionDescription& option);

/// What number_in() takes for `value`, which is in the option's range.
QString text_of(double value, const laplacian_lines::OptionDescription& option);

}  // namespace meshlab_host
