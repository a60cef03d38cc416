// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "laplacian_lines/field.h"
#include "laplacian_lines/triangle_mesh.h"

namespace line_renderer {

template <class Object>
class PerShareGroup;

struct SurfaceVertex {
    Eigen::Vector3f position;  ///< mesh coordinates
    Eigen::Vector3f normal;    ///< of the field: smoothed, zero where a vertex was dropped
};

struct Surface {
    std::vector<SurfaceVertex> vertices;
    std::vector<laplacian_lines::Triangle> triangles;  ///< with finite corners only
    /// How far curved faces of refined() meshes may be behind the flat ones that MeshLab draws,
    /// mesh units; else 0.
    double most_behind = 0;
};
using SurfacePointer = std::shared_ptr<const Surface>;

SurfacePointer make_surface(const laplacian_lines::TriangleMesh& mesh,
                            const laplacian_lines::Field& field);

std::size_t bytes_of(const Surface& surface);

struct SurfaceLayer {
    std::weak_ptr<const Surface> surface;
    Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();  ///< mesh to world coordinates
    double diagonal = 0;                                      ///< of the mesh, mesh units
    bool culls_back_faces = false;
    /// MeshLab's depth buffer has the faces, and nothing in front of them.
    bool is_in_depth_buffer = false;

    /// The diagonal follows from the surface.
    bool operator==(const SurfaceLayer& other) const {
        return !surface.owner_before(other.surface) && !other.surface.owner_before(surface) &&
               transform == other.transform && culls_back_faces == other.culls_back_faces &&
               is_in_depth_buffer == other.is_in_depth_buffer;
    }
};

/// Faces in OpenGL's memory, by share group; freed at the group's next drawing after the surface is
/// gone. GUI thread only.
class SurfaceBuffers {
public:
    SurfaceBuffers();
    ~SurfaceBuffers();

    /// Draws all faces with normals by the program in use, with the camera's matrices current;
    /// nothing if the surface is gone. Changes OpenGL's state: for renderers, which restore it.
    void draw(const SurfaceLayer& layer);

private:
    class Group;
    std::unique_ptr<PerShareGroup<Group>> groups_;
};

}  // namespace line_renderer
