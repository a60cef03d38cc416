// SPDX-License-Identifier: GPL-3.0-or-later
// line_truth [OPTION VALUE]... [MESH...]: how much of the arrises of flaked stones and machined
// parts is drawn, how much of what is drawn is one, and how much of a drawing noise and the
// terraces of segmented volumes leave.
//
// Recall is the share of the arrises' length within --reach of a line; precision the share of the
// length of ridges and creases within --reach of an arris, sharp or blunt; F1 their harmonic mean.
// All in space, hidden or not, for six eyes around the form; arrises that face away from an eye or
// are on its outline need no line, and ridges alone only have to draw convex ones. Stones are
// scored over all seeds.
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
