// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/surface.h"

#include <algorithm>
#include <map>

#include "gl_functions.h"
#include "per_share_group.h"

namespace line_renderer {

using laplacian_lines::Field;
using laplacian_lines::Triangle;
using laplacian_lines::TriangleMesh;

namespace {

// Mean edges. On noisy scans of 5,000 to 50,000 triangles the middle of an edge moves by up to .26,
// and those of its halves once more.
constexpr double kMostBehind = 0.35;

struct Buffers {
    GLuint vertices = 0;
    GLuint triangles = 0;
};

/// Leaves the buffer bound.
template <class T>
GLuint make_buffer(GLenum target, const std::vector<T>& content) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, GLsizeiptr(content.size() * sizeof(T)), content.data(), GL_STATIC_DRAW);
    return buffer;
}

const void* offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

}  // namespace

SurfacePointer make_surface(const TriangleMesh& mesh, const Field& field) {
    auto surface = std::make_shared<Surface>();
    surface->most_behind = kMostBehind * mesh.known_edge;
    surface->vertices.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        surface->vertices.push_back({mesh.positions[i].cast<float>(), field.normals.at(i)});

    const auto is_finite = [&](std::uint32_t corner) {
        return corner < surface->vertices.size() && surface->vertices[corner].position.allFinite();
    };
    surface->triangles.reserve(mesh.triangles.size());
    std::copy_if(mesh.triangles.begin(), mesh.triangles.end(),
                 std::back_inserter(surface->triangles), [&](const Triangle& triangle) {
                     return std::all_of(triangle.begin(), triangle.end(), is_finite);
                 });
    return surface;
}

std::size_t bytes_of(const Surface& surface) {
    return surface.vertices.capacity() * sizeof(SurfaceVertex) +
           surface.triangles.capacity() * sizeof(Triangle);
}

class SurfaceBuffers::Group {
public:
    void bind(const SurfacePointer& surface) {
        const auto [entry, is_new] = buffers_.try_emplace(surface);
        Buffers& buffers = entry->second;
        if (is_new) {
            buffers.vertices = make_buffer(GL_ARRAY_BUFFER, surface->vertices);
            buffers.triangles = make_buffer(GL_ELEMENT_ARRAY_BUFFER, surface->triangles);
        }
        glBindBuffer(GL_ARRAY_BUFFER, buffers.vertices);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.triangles);
    }

    void free_expired() {
        for (auto entry = buffers_.begin(); entry != buffers_.end();) {
            if (!entry->first.expired()) {
                ++entry;
                continue;
            }
            glDeleteBuffers(1, &entry->second.vertices);
            glDeleteBuffers(1, &entry->second.triangles);
            entry = buffers_.erase(entry);
        }
    }

private:
    std::map<std::weak_ptr<const Surface>, Buffers, std::owner_less<>> buffers_;
};

SurfaceBuffers::SurfaceBuffers() : groups_(std::make_unique<PerShareGroup<Group>>()) {}

SurfaceBuffers::~SurfaceBuffers() = default;

void SurfaceBuffers::draw(const SurfaceLayer& layer) {
    const SurfacePointer surface = layer.surface.lock();
    if (!surface) return;
    Group& group = groups_->current();
    group.free_expired();
    group.bind(surface);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(SurfaceVertex), offset(0));
    glNormalPointer(GL_FLOAT, sizeof(SurfaceVertex), offset(sizeof(Eigen::Vector3f)));
    (layer.culls_back_faces ? glEnable : glDisable)(GL_CULL_FACE);

    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glMultMatrixd(layer.transform.data());
    glDrawElements(GL_TRIANGLES, GLsizei(3 * surface->triangles.size()), GL_UNSIGNED_INT, nullptr);
    glPopMatrix();
}

}  // namespace line_renderer
