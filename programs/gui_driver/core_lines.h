// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <laplacian_lines/kernel_levels.h>
#include <laplacian_lines/precompute_options.h>
#include <meshlab_host/meshlab_api.h>
#include "decoration_parameters.h"

#include <list>
#include <map>

namespace driver {

/// Without deleted faces and vertices.
laplacian_lines::TriangleMesh liveTriangles(const CMeshO& mesh);

/// The lines that a layer should show, computed afresh from its geometry: independent of attributes
/// and of what the decoration keeps. Caches recent geometries.
class CoreLines {
public:
    /// For the current GL context's camera and these kernels. Valid until the next call.
    /// @throws std::exception if the layer can have no lines
    const laplacian_lines::LineSet& of(const MeshModel& mesh, const DecorationParameters& chosen,
                                       const std::vector<laplacian_lines::DrawnKernel>& kernels);

private:
    struct Known {
        laplacian_lines::TriangleMesh triangles;
        std::vector<double> options;
        laplacian_lines::LineExtractor extractor;
        std::map<double, laplacian_lines::KernelLaplacian> laplacians;  ///< by √h
    };
    static const laplacian_lines::KernelLaplacian& laplacian(
        Known& known, laplacian_lines::PrecomputeOptions options, double kernel_size);
    Known& known(const CMeshO& mesh, const laplacian_lines::PrecomputeOptions& options);

    std::list<Known> known_;  ///< the latest first
    laplacian_lines::ExtractionScratch scratch_;
    laplacian_lines::LineSet lines_, faded_lines_;
};

}  // namespace driver
