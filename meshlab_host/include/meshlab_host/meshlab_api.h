// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one place for MeshLab's differing headers and names. MESHLAB_API (2020, 2022 or 2025) comes
// from the build. Macros, not aliases, where Qt's moc reads the name.

#include <GL/glew.h>  // before every header that might include gl.h

#include <Eigen/Core>

#if MESHLAB_API < 2022
#include <common/interfaces.h>
#include <common/ml_shared_data_context.h>
#include <common/mlexception.h>
#define MESHLAB_HOST_FILTER_INTERFACE MeshFilterInterface
#define MESHLAB_HOST_FILTER_IID MESH_FILTER_INTERFACE_IID
#define MESHLAB_HOST_DECORATE_INTERFACE MeshDecorateInterface
#define MESHLAB_HOST_DECORATE_IID MESH_DECORATE_INTERFACE_IID
#define MESHLAB_HOST_LOG Log
#else
#include <common/globals.h>
#include <common/ml_document/mesh_document.h>
#include <common/ml_shared_data_context/ml_scene_gl_shared_data_context.h>
#include <common/mlexception.h>
#include <common/parameters/rich_parameter_list.h>
#include <common/plugins/interfaces/decorate_plugin.h>
#include <common/plugins/interfaces/filter_plugin.h>
#define MESHLAB_HOST_FILTER_INTERFACE FilterPlugin
#define MESHLAB_HOST_FILTER_IID FILTER_PLUGIN_IID
#define MESHLAB_HOST_DECORATE_INTERFACE DecoratePlugin
#define MESHLAB_HOST_DECORATE_IID DECORATE_PLUGIN_IID
#define MESHLAB_HOST_LOG log
#endif

namespace meshlab_host {

#if MESHLAB_API < 2022
using ActionPointer = QAction*;
#else
using ActionPointer = const QAction*;
#endif

/// A length, with a percentage beside it in dialogs.
#if MESHLAB_API < 2025
using RichLength = ::RichAbsPerc;
#else
using RichLength = ::RichPercentage;
#endif

/// A file to write, with a button. 2020.09 would ignore a typed name, so it gets a text.
#if MESHLAB_API < 2022
class RichFileToSave : public ::RichString {
public:
    RichFileToSave(const QString& name, const QString& value, const QString&, const QString& label,
                   const QString& help)
        : RichString(name, value, label, help) {}
};
#elif MESHLAB_API < 2025
using RichFileToSave = ::RichSaveFile;
#else
using RichFileToSave = ::RichFileSave;
#endif

inline Point3m point_of(const Eigen::Vector3d& p) {
    return {Scalarm(p.x()), Scalarm(p.y()), Scalarm(p.z())};
}

/// In world coordinates.
#if MESHLAB_API < 2022
using RichPlace = ::RichPoint3f;
using RichHeading = ::RichPoint3f;
#else
using RichPlace = ::RichPosition;
using RichHeading = ::RichDirection;
#endif

#if MESHLAB_API < 2025
inline bool is_point(const Value& value) {
    return value.isPoint3f();
}
inline Point3m point_in(const Value& value) {
    return value.getPoint3f();
}
#else
inline bool is_point(const Value& value) {
    return value.isPoint3();
}
inline Point3m point_in(const Value& value) {
    return value.getPoint3();
}
#endif

}  // namespace meshlab_host
