// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl_state_text.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>

#include <QStringList>
#include <algorithm>

namespace {

struct Name {
    const char* text;
    GLenum value;
};
#define NAME(x) \
    { #x, x }

constexpr Name switches[] = {NAME(GL_ALPHA_TEST),
                             NAME(GL_BLEND),
                             NAME(GL_CLIP_PLANE0),
                             NAME(GL_COLOR_LOGIC_OP),
                             NAME(GL_COLOR_MATERIAL),
                             NAME(GL_CULL_FACE),
                             NAME(GL_DEPTH_TEST),
                             NAME(GL_FOG),
                             NAME(GL_LIGHT0),
                             NAME(GL_LIGHTING),
                             NAME(GL_LINE_SMOOTH),
                             NAME(GL_LINE_STIPPLE),
                             NAME(GL_MULTISAMPLE),
                             NAME(GL_NORMALIZE),
                             NAME(GL_POINT_SMOOTH),
                             NAME(GL_POLYGON_OFFSET_FILL),
                             NAME(GL_POLYGON_OFFSET_LINE),
                             NAME(GL_SCISSOR_TEST),
                             NAME(GL_STENCIL_TEST),
                             NAME(GL_TEXTURE_2D),
                             NAME(GL_PRIMITIVE_RESTART),
                             NAME(GL_VERTEX_PROGRAM_POINT_SIZE),
                             NAME(GL_VERTEX_ARRAY),
                             NAME(GL_NORMAL_ARRAY),
                             NAME(GL_COLOR_ARRAY),
                             NAME(GL_TEXTURE_COORD_ARRAY)};

constexpr Name values[] = {NAME(GL_ACTIVE_TEXTURE),
                           NAME(GL_ARRAY_BUFFER_BINDING),
                           NAME(GL_ATTRIB_STACK_DEPTH),
                           NAME(GL_BLEND_DST_ALPHA),
                           NAME(GL_BLEND_DST_RGB),
                           NAME(GL_BLEND_EQUATION_RGB),
                           NAME(GL_BLEND_SRC_ALPHA),
                           NAME(GL_BLEND_SRC_RGB),
                           NAME(GL_CLIENT_ACTIVE_TEXTURE),
                           NAME(GL_CLIENT_ATTRIB_STACK_DEPTH),
                           NAME(GL_COLOR_WRITEMASK),
                           NAME(GL_CULL_FACE_MODE),
                           NAME(GL_CURRENT_COLOR),
                           NAME(GL_CURRENT_NORMAL),
                           NAME(GL_CURRENT_PROGRAM),
                           NAME(GL_DEPTH_FUNC),
                           NAME(GL_DEPTH_RANGE),
                           NAME(GL_DEPTH_WRITEMASK),
                           NAME(GL_DRAW_BUFFER),
                           NAME(GL_DRAW_FRAMEBUFFER_BINDING),
                           NAME(GL_ELEMENT_ARRAY_BUFFER_BINDING),
                           NAME(GL_FRONT_FACE),
                           NAME(GL_LINE_WIDTH),
                           NAME(GL_MATRIX_MODE),
                           NAME(GL_MODELVIEW_MATRIX),
                           NAME(GL_MODELVIEW_STACK_DEPTH),
                           NAME(GL_PACK_ALIGNMENT),
                           NAME(GL_POINT_SIZE),
                           NAME(GL_POLYGON_MODE),
                           NAME(GL_POLYGON_OFFSET_FACTOR),
                           NAME(GL_POLYGON_OFFSET_UNITS),
                           NAME(GL_PROJECTION_MATRIX),
                           NAME(GL_PROJECTION_STACK_DEPTH),
                           NAME(GL_READ_FRAMEBUFFER_BINDING),
                           NAME(GL_SHADE_MODEL),
                           NAME(GL_TEXTURE_BINDING_2D),
                           NAME(GL_UNPACK_ALIGNMENT),
                           NAME(GL_VERTEX_ARRAY_BINDING),
                           NAME(GL_VIEWPORT)};

/// OpenGL guarantees 16.
constexpr Name attribute_values[] = {NAME(GL_VERTEX_ATTRIB_ARRAY_ENABLED),
                                     NAME(GL_VERTEX_ATTRIB_ARRAY_DIVISOR)};
#undef NAME

constexpr int most_values = 16;  // of one name: a matrix

QString valuesOf(GLenum name) {
    GLdouble numbers[most_values];
    const GLdouble unused = -12345.678;
    std::fill(std::begin(numbers), std::end(numbers), unused);
    glGetDoublev(name, numbers);
    QStringList text;
    for (GLdouble number : numbers)
        if (number != unused) text << QString::number(number, 'g', 12);
    return text.join(' ');
}

}  // namespace

QString glStateText() {
    QStringList lines;
    while (const GLenum error = glGetError())
        lines << QString("error 0x%1").arg(error, 0, 16);
    for (const Name& name : switches)
        lines << QString("%1 %2").arg(name.text).arg(glIsEnabled(name.value));
    for (const Name& name : values)
        lines << QString("%1 %2").arg(name.text, valuesOf(name.value));
    for (GLuint i = 0; i < 16; ++i)
        for (const Name& name : attribute_values) {
            GLint value = 0;
            glGetVertexAttribiv(i, name.value, &value);
            lines << QString("%1 %2 %3").arg(name.text).arg(i).arg(value);
        }
    if (glGetError()) lines << "this context does not know all the names";
    return lines.join('\n') + '\n';
}
