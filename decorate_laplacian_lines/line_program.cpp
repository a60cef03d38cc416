// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_program.h"

#include <vector>

#include "line_shaders.h"

namespace {

/// What the driver says about a shader or program.
template <class GetParameter, class GetLog>
std::string infoLog(GLuint object, GetParameter get_parameter, GetLog get_log) {
    GLint length = 0;
    get_parameter(object, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> text(std::size_t(length) + 1, '\0');
    get_log(object, length, nullptr, text.data());
    return text.data();
}

/// 0 on failure, with the reason added to `failure`.
GLuint compile(GLenum kind, const char* source, std::string& failure) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    failure += infoLog(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    return 0;
}

GLuint link(GLuint vertex, GLuint fragment, std::string& failure) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    const char* const attributes[] = {"corner", "before", "start", "end", "after"};
    for (GLuint location = 0; location < 5; ++location)
        glBindAttribLocation(program, location, attributes[location]);
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) return program;
    failure += infoLog(program, glGetProgramiv, glGetProgramInfoLog);
    glDeleteProgram(program);
    return 0;
}

}  // namespace

LineProgram buildLineProgram() {
    LineProgram program;
    const GLuint vertex = compile(GL_VERTEX_SHADER, line_vertex_shader, program.failure);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, line_fragment_shader, program.failure);
    if (vertex && fragment) program.id = link(vertex, fragment, program.failure);
    glDeleteShader(vertex);  // a linked program keeps them as long as it needs; 0 is ignored
    glDeleteShader(fragment);
    if (!program.id) return program;
    program.to_eye = glGetUniformLocation(program.id, "to_eye");
    program.projection = glGetUniformLocation(program.id, "projection");
    program.half_viewport = glGetUniformLocation(program.id, "half_viewport");
    program.depth_bias = glGetUniformLocation(program.id, "depth_bias");
    program.color = glGetUniformLocation(program.id, "color");
    return program;
}
