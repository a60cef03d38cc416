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
#include "truth_options.h"

int main(int argc, char** argv) {
    using namespace benchmarks;
    TruthOptions options;
    return run_program(argc, argv, "[MESH...]", options.words(), [&](const auto& files) {
        options.check();
        for (const TruthTable& table : truth_tables())
            if (options.only.empty() || options.only == table.name) table.print(options, files);
        return true;
    });
}
