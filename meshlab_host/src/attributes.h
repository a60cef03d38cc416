// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <typeindex>
#include <vector>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

// Typed access to attributes: vcglib's own functions check only the type's size, some create what
// they look for, and they need a mesh that is not const.

using Attributes = std::set<vcg::PointerToAttribute>;
template <class T>
using VertexValues = vcg::SimpleTempData<CMeshO::VertContainer, T>;

inline const vcg::PointerToAttribute* find_attribute(const Attributes& attributes,
                                                     const char* name) {
    vcg::PointerToAttribute key;
    key._name = name;
    const auto found = attributes.find(key);
    return found == attributes.end() ? nullptr : &*found;
}

template <class T>
bool has_type(const vcg::PointerToAttribute& attribute) {
    return attribute._handle && attribute._type == std::type_index(typeid(T)) &&
           attribute._sizeof == int(sizeof(T)) && attribute._padding == 0;
}

/// By slot (see mesh_conversion.h); null if there is none of this name, type and length.
template <class T>
const std::vector<T>* find_vertex_values(const CMeshO& mesh, const char* name) {
    const vcg::PointerToAttribute* attribute = find_attribute(mesh.vert_attr, name);
    if (!attribute || !has_type<T>(*attribute)) return nullptr;
    const auto* values = static_cast<const VertexValues<T>*>(attribute->_handle);
    return values->data.size() == mesh.vert.size() ? &values->data : nullptr;
}

inline void remove_vertex_attribute(CMeshO& mesh, const char* name) {
    vcg::tri::Allocator<CMeshO>::DeletePerVertexAttribute(mesh, std::string(name));
}

/// As find_vertex_values(), created or replaced if need be.
template <class T>
std::vector<T>& ensure_vertex_values(CMeshO& mesh, const char* name) {
    if (!find_vertex_values<T>(mesh, name)) {
        remove_vertex_attribute(mesh, name);
        vcg::tri::Allocator<CMeshO>::AddPerVertexAttribute<T>(mesh, std::string(name));
    }
    return *const_cast<std::vector<T>*>(
        find_vertex_values<T>(mesh, name));  // the mesh is not const
}

template <class T>
const T* find_mesh_value(const CMeshO& mesh, const char* name) {
    const vcg::PointerToAttribute* attribute = find_attribute(mesh.mesh_attr, name);
    if (!attribute || !has_type<T>(*attribute)) return nullptr;
    return static_cast<const T*>(attribute->_handle->DataBegin());
}

inline void remove_mesh_value(CMeshO& mesh, const char* name) {
    vcg::tri::Allocator<CMeshO>::DeletePerMeshAttribute(mesh, std::string(name));
}

template <class T>
void set_mesh_value(CMeshO& mesh, const char* name, const T& value) {
    remove_mesh_value(mesh, name);
    auto handle = vcg::tri::Allocator<CMeshO>::AddPerMeshAttribute<T>(mesh, std::string(name));
    handle() = value;
}

}  // namespace meshlab_host
