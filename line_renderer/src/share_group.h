// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

class QObject;

namespace line_renderer {

/// Names the set of OpenGL contexts that share objects with the current one: all views of one
/// document. Null if no context is current. The name is only good for comparing.
using ShareGroup = const void*;

ShareGroup currentShareGroup();

/// Calls `gone` when the group has died and its OpenGL objects with it. `group` must come from
/// currentShareGroup(); nothing is called after `receiver` is destroyed. GUI thread only.
void whenGone(ShareGroup group, QObject* receiver, std::function<void()> gone);

}  // namespace line_renderer
