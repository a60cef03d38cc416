// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <malloc.h>

#include <Eigen/Core>
#include <fstream>
#include <string>
#include <vector>

#include "field/shape_operators.h"
#include "laplacian_lines/triangle_mesh.h"
#include "mesh/prepared_mesh.h"

namespace benchmarks {

/// Belkin's operator without the rest of precompute(): a mesh whose smoothed normals and shape
/// operators are there, as the default options have them. Uses the core's inner headers.
class LaplacianAlone {
public:
    /// @throws laplacian_lines::Error: InvalidMesh, EmptyMesh.
    explicit LaplacianAlone(const laplacian_lines::TriangleMesh& mesh);

    /// Δn of all vertices to 1e-3, corrections included. `size`: √h in mean edges.
    std::vector<Eigen::Vector3d> compute(double size) const;

private:
    laplacian_lines::PreparedMesh mesh_;
    laplacian_lines::SpatialTree tree_;
    std::vector<Eigen::Vector3d> normals_;
    laplacian_lines::ShapeOperators shape_operators_;
};

/// Memory that the process takes at most, beyond what it had when this was made. Linux only: the
/// kernel's mark of the largest resident size is set back, then read.
class PeakMemory {
public:
    PeakMemory() {
        malloc_trim(0);
        std::ofstream("/proc/self/clear_refs") << '5';
        before_ = resident("VmRSS:");
    }

    /// In bytes.
    double bytes() const { return resident("VmHWM:") - before_; }

private:
    static double resident(const std::string& name) {
        std::ifstream status("/proc/self/status");
        std::string word;
        while (status >> word)
            if (word == name) {
                double kilobytes = 0;
                status >> kilobytes;
                return 1024 * kilobytes;
            }
        return 0;
    }

    double before_ = 0;
};

}  // namespace benchmarks
