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

/// Belkin's operator alone, on smoothed normals and shape operators by the defaults. Uses internal
/// headers.
class LaplacianAlone {
public:
    /// @throws laplacian_lines::Error: InvalidMesh, EmptyMesh.
    explicit LaplacianAlone(const laplacian_lines::TriangleMesh& mesh);

    /// Δn to 1e-3, with corrections. `size`: √h in mean edges.
    std::vector<Eigen::Vector3d> compute(double size) const;

private:
    laplacian_lines::PreparedMesh mesh_;
    laplacian_lines::SpatialTree tree_;
    std::vector<Eigen::Vector3d> normals_;
    laplacian_lines::ShapeOperators shape_operators_;
};

/// The process's peak memory beyond that at construction. Linux only: resets the kernel's
/// high-water mark.
class PeakMemory {
public:
    PeakMemory() {
        malloc_trim(0);
        std::ofstream("/proc/self/clear_refs") << '5';
        before_ = resident("VmRSS:");
    }

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
