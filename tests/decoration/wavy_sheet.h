// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "meshlab_host/meshlab_api.h"

/// n by n vertices.
inline void make_sheet(CMeshO& mesh, int n) {
    auto vertex = vcg::tri::Allocator<CMeshO>::AddVertices(mesh, std::size_t(n) * std::size_t(n));
    for (int i = 0; i < n * n; ++i, ++vertex) {
        const double x = double(i % n) / n, y = double(i / n) / n;
        vertex->P() = Point3m(Scalarm(x), Scalarm(y), Scalarm(0.1 * std::sin(9 * x + 4 * y)));
    }
    for (int i = 0; i < n * (n - 1); ++i) {
        if (i % n == n - 1) continue;
        vcg::tri::Allocator<CMeshO>::AddFace(mesh, i, i + 1, i + n);
        vcg::tri::Allocator<CMeshO>::AddFace(mesh, i + 1, i + n + 1, i + n);
    }
}
