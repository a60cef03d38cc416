// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "gl_functions.h"

namespace line_renderer {

/// Belongs to the share group that was current when it was made.
class ShaderProgram {
public:
    /// Attributes get their indices in `attributes` as locations. @throws std::runtime_error:
    /// `refusal`, such as "Lines cannot be drawn", and the reason: no shaders (OpenGL 2.0), or the
    /// compiler's message
    ShaderProgram(const char* refusal, const char* vertex_shader, const char* fragment_shader,
                  const std::vector<const char*>& attributes = {});

    void use() const { glUseProgram(id_); }

    // Uniforms, of the program in use.
    void set(const char* name, int value) const { glUniform1i(location(name), value); }
    void set(const char* name, float value) const { glUniform1f(location(name), value); }
    void set(const char* name, const Eigen::Vector2f& value) const {
        glUniform2fv(location(name), 1, value.data());
    }
    void set(const char* name, const Eigen::Vector4f& value) const {
        glUniform4fv(location(name), 1, value.data());
    }
    void set(const char* name, const Eigen::Matrix4f& value) const {
        glUniformMatrix4fv(location(name), 1, GL_FALSE, value.data());
    }
    template <std::size_t Count>
    void set(const char* name, const std::array<float, Count>& values) const {
        glUniform1fv(location(name), GLsizei(Count), values.data());
    }
    template <std::size_t Count>
    void set(const char* name, const std::array<Eigen::Vector4f, Count>& values) const {
        glUniform4fv(location(name), GLsizei(Count), values.front().data());
    }

private:
    GLint location(const char* name) const { return glGetUniformLocation(id_, name); }

    GLuint id_ = 0;
};

}  // namespace line_renderer
