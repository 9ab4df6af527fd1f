#pragma once

// Reads a texture on Mesa's software rasteriser, by a compute shader in an OpenGL context without window or screen.

#include "emit/lut.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace fresnel::test {

class texture_device {
public:
    /// Throws std::runtime_error where the machine has none; `what` may follow "skipped: ".
    texture_device() {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
        if (!epoxy_has_egl() || !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
            throw std::runtime_error("no EGL that does without a screen");
        display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE)
            throw std::runtime_error("EGL finds no device");
        const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
        eglBindAPI(EGL_OPENGL_API);
        const EGLContext context = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
        if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE)
            throw std::runtime_error("the device has no OpenGL 4.3");
    }
    ~texture_device() { eglTerminate(display_); }
    texture_device(const texture_device&) = delete;
    texture_device& operator=(const texture_device&) = delete;

    /// Three floats for each pair (cos_i, second axis): what the shader's `result = ...` makes of `cos_i` and `by`.
    std::vector<float> run(const emit::lut& table, const std::string& functions,
                           const std::string& expression, const std::vector<float>& pairs) const {
        const std::size_t count = pairs.size() / 2;
        const GLuint program =
            link("#version 430\nlayout(local_size_x = 64) in;\n"
                 "layout(binding = 0) uniform sampler2D table_;\n"
                 "layout(std430, binding = 0) readonly buffer A { float pairs[]; };\n"
                 "layout(std430, binding = 1) writeonly buffer B { float results[]; };\n" +
                 functions +
                 "void main() {\n    uint i = gl_GlobalInvocationID.x;\n"
                 "    if (i >= " +
                 std::to_string(count) +
                 "u) return;\n    float cos_i = pairs[2u * i], by = pairs[2u * i + 1u];\n"
                 "    vec3 result = vec3(" +
                 expression +
                 ");\n    results[3u * i] = result.r;\n    results[3u * i + 1u] = result.g;\n"
                 "    results[3u * i + 2u] = result.b;\n}\n");
        std::vector<float> results(3 * count);
        GLuint buffers[2], texture = 0;
        glGenBuffers(2, buffers), glGenTextures(1, &texture);
        bind(buffers[0], 0, pairs.data(), pairs.size());
        bind(buffers[1], 1, nullptr, results.size());
        upload(texture, table);
        glUseProgram(program);
        glDispatchCompute(static_cast<GLuint>((count + 63) / 64), 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
                           static_cast<GLsizeiptr>(results.size() * sizeof(float)), results.data());
        const GLenum error = glGetError();
        glDeleteBuffers(2, buffers), glDeleteTextures(1, &texture), glDeleteProgram(program);
        if (error != GL_NO_ERROR) throw std::logic_error("OpenGL error " + std::to_string(error));
        return results;
    }

private:
    static void bind(GLuint buffer, GLuint binding, const float* data, std::size_t count) {
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
        glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(count * sizeof(float)), data,
                     GL_STATIC_READ);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
    }

    static void upload(GLuint texture, const emit::lut& table) {
        const bool rgb = table.channels() == 3;
        const GLint one = rgb ? GL_RGB8 : GL_R8, two = rgb ? GL_RGB16 : GL_R16,
                    half = rgb ? GL_RGB16F : GL_R16F, full = rgb ? GL_RGB32F : GL_R32F;
        const GLint format = table.format == emit::texel_format::r8     ? one
                             : table.format == emit::texel_format::r16  ? two
                             : table.format == emit::texel_format::r16f ? half
                                                                        : full;
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, format, static_cast<GLsizei>(table.columns),
                     static_cast<GLsizei>(table.rows), 0, rgb ? GL_RGB : GL_RED, GL_FLOAT,
                     table.texels.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }

    static GLuint link(const std::string& source) {
        const char* lines = source.c_str();
        const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &lines);
        GLint good = GL_FALSE;
        glGetProgramiv(program, GL_LINK_STATUS, &good);
        if (good == GL_TRUE) return program;
        std::string log(4096, '\0');
        glGetProgramInfoLog(program, 4096, nullptr, log.data());
        throw std::logic_error("the shader was refused:\n" + log.substr(0, log.find('\0')) + source);
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
};

} // namespace fresnel::test
