// SPDX-License-Identifier: GPL-3.0-or-later
#include "shader_program.h"

namespace line_renderer {
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

GLuint link(GLuint vertex, GLuint fragment, const std::vector<const char*>& attributes,
            std::string& failure) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    for (GLuint location = 0; location < attributes.size(); ++location)
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

GLuint buildShaderProgram(const char* vertex_shader, const char* fragment_shader,
                          const std::vector<const char*>& attributes, std::string& failure) {
    const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_shader, failure);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_shader, failure);
    const GLuint program = vertex && fragment ? link(vertex, fragment, attributes, failure) : 0;
    glDeleteShader(vertex);  // a linked program keeps them as long as it needs; 0 is ignored
    glDeleteShader(fragment);
    return program;
}

}  // namespace line_renderer
