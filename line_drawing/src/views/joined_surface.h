// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "line_drawing/object.h"

namespace line_drawing {

/// All objects as one mesh, which hides what is behind it.
class JoinedSurface {
public:
    explicit JoinedSurface(const Objects& objects);
    JoinedSurface(const JoinedSurface&) = delete;
    JoinedSurface& operator=(const JoinedSurface&) = delete;

    const laplacian_lines::TriangleMesh& mesh() const { return mesh_; }

private:
    laplacian_lines::TriangleMesh joined_;  ///< empty of a single object, which is not copied
    const laplacian_lines::TriangleMesh& mesh_;
};

}  // namespace line_drawing
