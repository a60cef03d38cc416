// SPDX-License-Identifier: GPL-3.0-or-later
#include "share_group.h"

#include <QOpenGLContext>

namespace line_renderer {

ShareGroup currentShareGroup() {
    return QOpenGLContextGroup::currentContextGroup();
}

void whenGone(ShareGroup group, QObject* receiver, std::function<void()> gone) {
    const auto* object = static_cast<const QOpenGLContextGroup*>(group);
    if (object) QObject::connect(object, &QObject::destroyed, receiver, std::move(gone));
}

}  // namespace line_renderer
