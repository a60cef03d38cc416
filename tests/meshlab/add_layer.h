// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "laplacian_lines/triangle_mesh.h"
#include "meshlab_host/meshlab_api.h"

/// A new layer, which is then the document's current one; without normals.
inline CMeshO& add_layer(MeshDocument& document, const char* name,
                         const laplacian_lines::TriangleMesh& source) {
    CMeshO& mesh = document.addNewMesh("", name)->cm;
    auto vertex = vcg::tri::Allocator<CMeshO>::AddVertices(mesh, source.positions.size());
    for (const Eigen::Vector3d& p : source.positions)
        (vertex++)->P() = Point3m(Scalarm(p.x()), Scalarm(p.y()), Scalarm(p.z()));
    auto face = vcg::tri::Allocator<CMeshO>::AddFaces(mesh, source.triangles.size());
    for (const laplacian_lines::Triangle& t : source.triangles) {
        for (int corner = 0; corner < 3; ++corner)
            face->V(corner) = &mesh.vert[t[std::size_t(corner)]];
        ++face;
    }
    vcg::tri::UpdateBounding<CMeshO>::Box(mesh);
    return mesh;
}
