// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl_state.h"

#include <initializer_list>

namespace line_renderer {

GlState::GlState() : has_vertex_arrays_(gl_features().array_objects) {
    glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &array_buffer_);
    if (has_vertex_arrays_) {
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertex_array_);
        glBindVertexArray(0);
    }
    glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &element_buffer_);  // of the array object bound
    glGetIntegerv(GL_ACTIVE_TEXTURE, &texture_unit_);
    glActiveTexture(GL_TEXTURE0);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture_);
    glPushAttrib(GL_ENABLE_BIT | GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_POLYGON_BIT |
                 GL_TRANSFORM_BIT);
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);

    for (GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
        glDisableClientState(array);
    for (GLenum feature : {GL_CULL_FACE, GL_ALPHA_TEST, GL_POLYGON_OFFSET_FILL})
        glDisable(feature);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    // Alpha stays opaque where lines are, for snapshots without background.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

GlState::~GlState() {
    glPopClientAttrib();
    glPopAttrib();
    glBindTexture(GL_TEXTURE_2D, GLuint(texture_));
    glActiveTexture(GLenum(texture_unit_));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, GLuint(element_buffer_));
    if (has_vertex_arrays_) glBindVertexArray(GLuint(vertex_array_));
    glBindBuffer(GL_ARRAY_BUFFER, GLuint(array_buffer_));
    glUseProgram(GLuint(program_));
}

}  // namespace line_renderer
