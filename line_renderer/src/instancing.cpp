// SPDX-License-Identifier: GPL-3.0-or-later
#include "instancing.h"

namespace line_renderer {

bool canDrawInstanced() {
    return GLEW_VERSION_3_3 ||
           (GLEW_VERSION_2_0 && GLEW_ARB_instanced_arrays && GLEW_ARB_draw_instanced);
}

void setDivisor(GLuint attribute, GLuint divisor) {
    if (GLEW_VERSION_3_3)
        glVertexAttribDivisor(attribute, divisor);
    else
        glVertexAttribDivisorARB(attribute, divisor);
}

void drawInstanced(GLenum mode, GLsizei vertices, GLsizei instances) {
    if (GLEW_VERSION_3_3)
        glDrawArraysInstanced(mode, 0, vertices, instances);
    else
        glDrawArraysInstancedARB(mode, 0, vertices, instances);
}

}  // namespace line_renderer
