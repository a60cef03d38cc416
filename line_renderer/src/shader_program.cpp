// SPDX-License-Identifier: GPL-3.0-or-later
#include "shader_program.h"

#include <stdexcept>
#include <string>

namespace line_renderer {
namespace {

template <class GetParameter, class GetLog>
std::string info_log(GLuint object, GetParameter get_parameter, GetLog get_log) {
    GLint length = 0;
    get_parameter(object, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> text(std::size_t(length) + 1, '\0');
    get_log(object, length, nullptr, text.data());
    return text.data();
}

/// Scoped; a linked program keeps what it needs.
class Shader {
public:
    explicit Shader(GLenum kind) : id_(glCreateShader(kind)) {}
    ~Shader() { glDeleteShader(id_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    GLuint id() const { return id_; }

    /// @throws std::runtime_error with the compiler's message
    void compile(const char* source) const {
        glShaderSource(id_, 1, &source, nullptr);
        glCompileShader(id_);
        GLint compiled = GL_FALSE;
        glGetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
        if (!compiled) throw std::runtime_error(info_log(id_, glGetShaderiv, glGetShaderInfoLog));
    }

private:
    GLuint id_;
};

GLuint link(const Shader& vertex, const Shader& fragment,
            const std::vector<const char*>& attributes) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, vertex.id());
    glAttachShader(program, fragment.id());
    for (GLuint location = 0; location < attributes.size(); ++location)
        glBindAttribLocation(program, location, attributes[location]);
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) return program;
    const std::runtime_error failure(info_log(program, glGetProgramiv, glGetProgramInfoLog));
    glDeleteProgram(program);
    throw failure;
}

GLuint build(const char* vertex_shader, const char* fragment_shader,
             const std::vector<const char*>& attributes) {
    if (!gl_features().shaders) throw std::runtime_error("shaders (OpenGL 2.0) are not available.");
    const Shader vertex(GL_VERTEX_SHADER), fragment(GL_FRAGMENT_SHADER);
    vertex.compile(vertex_shader);
    fragment.compile(fragment_shader);
    return link(vertex, fragment, attributes);
}

}  // namespace

ShaderProgram::ShaderProgram(const char* refusal, const char* vertex_shader,
                             const char* fragment_shader,
                             const std::vector<const char*>& attributes) {
    try {
        id_ = build(vertex_shader, fragment_shader, attributes);
    } catch (const std::runtime_error& reason) {
        throw std::runtime_error(std::string(refusal) + ": " + reason.what());
    }
}

}  // namespace line_renderer
