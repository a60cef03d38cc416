// SPDX-License-Identifier: GPL-3.0-or-later
// line_truth [OPTION VALUE]... [MESH...]: how much of the arrises of flaked stones and machined
// parts is drawn, how much of what is drawn is one, and how much of a drawing noise and
// the terraces of segmented volumes leave.
//
// Recall is the share of the length of arrises that has a line within --reach; precision the share
// of the length of ridges and creases that has an arris, sharp or blunt, within it; F1 their
// harmonic mean. All of it is in space, hidden or not, for six eyes around the form; arrises that
// face away from an eye, or are on its outline, need no line. Ridges alone have to draw the convex
// arrises only. Scores of stones are of all seeds together.
#include <cstdio>
#include <exception>
#include <stdexcept>

#include "truth_tables.h"

int main(int argc, char** argv) {
    using namespace benchmarks;
    try {
        const TruthOptions options = parse_truth_options({argv + 1, argv + argc});
        if (options.stones) print_stones(options);
        if (options.parts) print_parts(options);
        if (options.drawings) print_drawings(options);
        if (options.kinds_alone) print_kinds_alone(options);
        if (options.crests) print_crests(options);
        if (options.terraces) print_terraces(options);
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr, "line_truth: %s\n%s", error.what(), truth_usage);
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "line_truth: %s\n", error.what());
        return 1;
    }
    return 0;
}
