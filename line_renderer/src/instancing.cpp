// SPDX-License-Identifier: GPL-3.0-or-later
#include "instancing.h"

namespace line_renderer {

bool canDrawInstanced() {
    return glFeatures().instancing || glFeatures().old_instancing;
}

void setDivisor(GLuint attribute, GLuint divisor) {
    if (glFeatures().instancing)
        glVertexAttribDivisor(attribute, divisor);
    else
        glVertexAttribDivisorARB(attribute, divisor);
}

void drawInstanced(GLenum mode, GLsizei vertices, GLsizei instances) {
    if (glFeatures().instancing)
        glDrawArraysInstanced(mode, 0, vertices, instances);
    else
        glDrawArraysInstancedARB(mode, 0, vertices, instances);
}

}  // namespace line_renderer
