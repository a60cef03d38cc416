// SPDX-License-Identifier: GPL-3.0-or-later
#include "core_lines.h"

#include <laplacian_lines/option_table.h>
#include <laplacian_lines/precompute.h>
#include <meshlab_host/camera.h>
#include <meshlab_host/field_attributes.h>

#include <algorithm>
#include <cstring>

namespace driver {

using laplacian_lines::DrawnKernel;
using laplacian_lines::LineExtractor;
using laplacian_lines::LineSet;
using laplacian_lines::PrecomputeOptions;
using laplacian_lines::TriangleMesh;
using laplacian_lines::View;

namespace {

constexpr std::size_t most_known = 8;

// NaN equals itself here.
template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || !std::memcmp(a.data(), b.data(), a.size() * sizeof(T)));
}

/// The filter's options while its results belong to the mesh, else the defaults.
PrecomputeOptions optionsFor(const CMeshO& mesh) {
    using namespace meshlab_host;
    if (fieldStatus(mesh, geometryStamp(mesh)) != FieldStatus::Current) return {};
    return readFieldRecord(mesh)->options;
}

std::vector<double> valuesOf(const PrecomputeOptions& options) {
    std::vector<double> values;
    for (const auto& row : laplacian_lines::precompute_option_table())
        values.push_back(row.get(options));
    return values;
}

View viewOf(const CMeshO& mesh, const DecorationParameters& chosen) {
    const meshlab_host::CameraMatrices camera = meshlab_host::cameraFromGl();
    const Eigen::Matrix4d layer = meshlab_host::layerTransform(mesh);
    auto view = meshlab_host::viewFromMatrices(camera.modelview, camera.projection, layer);
    if (!view) throw std::runtime_error("the layer's transformation has no inverse");
    if (chosen.light == Light::FixedToTheCamera)
        view->light = meshlab_host::directionInMesh(meshlab_host::towardsLight(chosen.camera_light),
                                                    camera.modelview, layer);
    return *view;
}

}  // namespace

TriangleMesh liveTriangles(const CMeshO& mesh) {
    TriangleMesh result;
    std::vector<std::uint32_t> number(mesh.vert.size());
    for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
        if (mesh.vert[i].IsD()) continue;
        number[i] = std::uint32_t(result.positions.size());
        const auto& p = mesh.vert[i].cP();
        result.positions.emplace_back(p[0], p[1], p[2]);
    }
    for (const CFaceO& f : mesh.face)
        if (!f.IsD())
            result.triangles.push_back({number[vcg::tri::Index(mesh, f.cV(0))],
                                        number[vcg::tri::Index(mesh, f.cV(1))],
                                        number[vcg::tri::Index(mesh, f.cV(2))]});
    return result;
}

const LineSet& CoreLines::of(const MeshModel& mesh, const DecorationParameters& chosen,
                             const std::vector<DrawnKernel>& kernels) {
    const View view = viewOf(mesh.cm, chosen);
    PrecomputeOptions options = optionsFor(mesh.cm);
    options.curvature_derivatives = chosen.style.shows.needs_derivatives();
    Known& found = known(mesh.cm, options);
    options.curvature_derivatives = false;
    std::vector<DrawnKernel> own;
    for (const DrawnKernel& kernel : kernels) {
        own.push_back({kernel.size, nullptr, kernel.share});
        if (kernel.size > 0) own.back().laplacian = &laplacian(found, options, kernel.size);
    }
    laplacian_lines::extract_kernels(found.extractor, view, chosen.style, own, scratch_,
                                     faded_lines_, lines_);
    return lines_;
}

const laplacian_lines::KernelLaplacian& CoreLines::laplacian(Known& known,
                                                             PrecomputeOptions options,
                                                             double kernel_size) {
    auto found = known.laplacians.find(kernel_size);
    if (found == known.laplacians.end()) {
        options.drawn_kernel_size = kernel_size;
        const auto field = laplacian_lines::precompute(known.triangles, options);
        found = known.laplacians
                    .emplace(kernel_size, known.extractor.laplacian_of(known.triangles, field))
                    .first;
    }
    return found->second;
}

CoreLines::Known& CoreLines::known(const CMeshO& mesh, const PrecomputeOptions& options) {
    TriangleMesh triangles = liveTriangles(mesh);
    std::vector<double> values = valuesOf(options);
    const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& known) {
        return known.options == values &&
               sameBytes(known.triangles.positions, triangles.positions) &&
               sameBytes(known.triangles.triangles, triangles.triangles);
    });
    if (found != known_.end()) {
        known_.splice(known_.begin(), known_, found);
    } else {
        LineExtractor fresh(triangles, laplacian_lines::precompute(triangles, options));
        known_.push_front({std::move(triangles), std::move(values), std::move(fresh), {}});
        if (known_.size() > most_known) known_.pop_back();
    }
    return known_.front();
}

}  // namespace driver
