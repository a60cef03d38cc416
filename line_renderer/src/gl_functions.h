// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>

/// OpenGL beyond version 1.1, found through Qt, since its library has another name on each system.
/// In this namespace the usual names are these functions.
namespace line_renderer {

/// Null if the current context, or Qt, has no such function.
void (*find_gl_function(const char* name))();

/// Looked up when it is first needed, which takes a current context.
template <class Pointer>
class GlFunction;

template <class Result, class... Arguments>
class GlFunction<Result(APIENTRYP)(Arguments...)> {
public:
    using Pointer = Result(APIENTRYP)(Arguments...);

    constexpr explicit GlFunction(const char* name) : name_(name) {}

    Result operator()(Arguments... arguments) { return pointer()(arguments...); }
    /// Tests replace it.
    Pointer& pointer() {
        if (!pointer_) pointer_ = reinterpret_cast<Pointer>(find_gl_function(name_));
        return pointer_;
    }

private:
    const char* name_;
    Pointer pointer_ = nullptr;
};

/// Features of the first context, assumed for all. Tests change them.
struct GlFeatures {
    bool shaders;        ///< OpenGL 2.0
    bool array_objects;  ///< OpenGL 3.0 or an extension, as the next two
    bool framebuffers;
    bool buffer_ranges;
    bool instancing;      ///< OpenGL 3.3
    bool old_instancing;  ///< by extensions of OpenGL 2
};
GlFeatures& gl_features();

#define GL_FUNCTION(name, type) inline GlFunction<type> name(#name)
GL_FUNCTION(glActiveTexture, PFNGLACTIVETEXTUREARBPROC);  // Mesa has no other type
GL_FUNCTION(glAttachShader, PFNGLATTACHSHADERPROC);
GL_FUNCTION(glBindAttribLocation, PFNGLBINDATTRIBLOCATIONPROC);
GL_FUNCTION(glBindBuffer, PFNGLBINDBUFFERPROC);
GL_FUNCTION(glBindFramebuffer, PFNGLBINDFRAMEBUFFERPROC);
GL_FUNCTION(glBindVertexArray, PFNGLBINDVERTEXARRAYPROC);
GL_FUNCTION(glBlendFuncSeparate, PFNGLBLENDFUNCSEPARATEPROC);
GL_FUNCTION(glBufferData, PFNGLBUFFERDATAPROC);
GL_FUNCTION(glCheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC);
GL_FUNCTION(glCompileShader, PFNGLCOMPILESHADERPROC);
GL_FUNCTION(glCreateProgram, PFNGLCREATEPROGRAMPROC);
GL_FUNCTION(glCreateShader, PFNGLCREATESHADERPROC);
GL_FUNCTION(glDeleteBuffers, PFNGLDELETEBUFFERSPROC);
GL_FUNCTION(glDeleteFramebuffers, PFNGLDELETEFRAMEBUFFERSPROC);
GL_FUNCTION(glDeleteProgram, PFNGLDELETEPROGRAMPROC);
GL_FUNCTION(glDeleteShader, PFNGLDELETESHADERPROC);
GL_FUNCTION(glDrawArraysInstanced, PFNGLDRAWARRAYSINSTANCEDPROC);
GL_FUNCTION(glDrawArraysInstancedARB, PFNGLDRAWARRAYSINSTANCEDARBPROC);
GL_FUNCTION(glEnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC);
GL_FUNCTION(glFramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC);
GL_FUNCTION(glGenBuffers, PFNGLGENBUFFERSPROC);
GL_FUNCTION(glGenFramebuffers, PFNGLGENFRAMEBUFFERSPROC);
GL_FUNCTION(glGetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC);
GL_FUNCTION(glGetProgramiv, PFNGLGETPROGRAMIVPROC);
GL_FUNCTION(glGetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC);
GL_FUNCTION(glGetShaderiv, PFNGLGETSHADERIVPROC);
GL_FUNCTION(glGetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC);
GL_FUNCTION(glLinkProgram, PFNGLLINKPROGRAMPROC);
GL_FUNCTION(glMapBuffer, PFNGLMAPBUFFERPROC);
GL_FUNCTION(glMapBufferRange, PFNGLMAPBUFFERRANGEPROC);
GL_FUNCTION(glShaderSource, PFNGLSHADERSOURCEPROC);
GL_FUNCTION(glUniform1f, PFNGLUNIFORM1FPROC);
GL_FUNCTION(glUniform1fv, PFNGLUNIFORM1FVPROC);
GL_FUNCTION(glUniform1i, PFNGLUNIFORM1IPROC);
GL_FUNCTION(glUniform2fv, PFNGLUNIFORM2FVPROC);
GL_FUNCTION(glUniform4fv, PFNGLUNIFORM4FVPROC);
GL_FUNCTION(glUniformMatrix4fv, PFNGLUNIFORMMATRIX4FVPROC);
GL_FUNCTION(glUnmapBuffer, PFNGLUNMAPBUFFERPROC);
GL_FUNCTION(glUseProgram, PFNGLUSEPROGRAMPROC);
GL_FUNCTION(glVertexAttribDivisor, PFNGLVERTEXATTRIBDIVISORPROC);
GL_FUNCTION(glVertexAttribDivisorARB, PFNGLVERTEXATTRIBDIVISORARBPROC);
GL_FUNCTION(glVertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC);
#undef GL_FUNCTION

/// Corner and size.
inline std::array<GLint, 4> current_viewport() {
    std::array<GLint, 4> viewport;
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    return viewport;
}

// Instanced drawing, by OpenGL 3.3 or older extensions. Needs a current context.

inline bool can_draw_instanced() {
    return gl_features().instancing || gl_features().old_instancing;
}

inline void set_divisor(GLuint attribute, GLuint divisor) {
    if (gl_features().instancing)
        glVertexAttribDivisor(attribute, divisor);
    else
        glVertexAttribDivisorARB(attribute, divisor);
}

/// From vertex 0.
inline void draw_instanced(GLenum mode, GLsizei vertices, GLsizei instances) {
    if (gl_features().instancing)
        glDrawArraysInstanced(mode, 0, vertices, instances);
    else
        glDrawArraysInstancedARB(mode, 0, vertices, instances);
}

}  // namespace line_renderer
