// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_renderer/surface_buffers.h"

namespace line_renderer {
namespace {

/// Fills a new buffer and leaves it bound.
template <class T>
GLuint makeBuffer(GLenum target, const std::vector<T>& content) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, GLsizeiptr(content.size() * sizeof(T)), content.data(), GL_STATIC_DRAW);
    return buffer;
}

template <class Map>
void freeExpired(Map& buffers) {
    for (auto entry = buffers.begin(); entry != buffers.end();) {
        if (!entry->first.expired()) {
            ++entry;
            continue;
        }
        glDeleteBuffers(1, &entry->second.vertices);
        glDeleteBuffers(1, &entry->second.triangles);
        entry = buffers.erase(entry);
    }
}

const void* offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

}  // namespace

SurfaceBuffers::Group& SurfaceBuffers::currentGroup() {
    const ShareGroup group = currentShareGroup();
    const auto [place, is_new] = groups_.try_emplace(group);
    if (is_new) whenGone(group, &receiver_, [this, group] { groups_.erase(group); });
    freeExpired(place->second);
    return place->second;
}

void SurfaceBuffers::bind(Group& group, const SurfacePointer& surface) {
    const auto [entry, is_new] = group.try_emplace(surface);
    Buffers& buffers = entry->second;
    if (is_new) {
        buffers.vertices = makeBuffer(GL_ARRAY_BUFFER, surface->vertices);
        buffers.triangles = makeBuffer(GL_ELEMENT_ARRAY_BUFFER, surface->triangles);
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffers.vertices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.triangles);
}

void SurfaceBuffers::draw(const SurfaceLayer& layer) {
    const SurfacePointer surface = layer.surface.lock();
    if (!surface) return;
    bind(currentGroup(), surface);
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
