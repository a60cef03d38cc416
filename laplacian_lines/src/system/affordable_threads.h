// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace laplacian_lines {

/// How many threads, 1..wanted, OpenMP can start for the calling thread. Where memory does not
/// suffice for their stacks, OpenMP would end the whole program.
int affordable_threads(int wanted);

}  // namespace laplacian_lines
