#pragma once

// Reads a texture on OpenGL's device: by a compute shader, and by a program that draws with it.

#include "emit/lut.hpp"
#include "render/compute.hpp"

#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace fresnel::test {

/// Its making throws render::no_device.
class texture_device {
public:
    /// Three floats for each pair (cos_i, second axis): what the shader's `result = ...` makes of `cos_i` and `by`.
    std::vector<float> run(const emit::lut& table, const std::string& functions,
                           const std::string& expression, const std::vector<float>& pairs) const {
        const std::size_t count = pairs.size() / 2;
        GLuint texture = 0;
        glGenTextures(1, &texture);
        upload(texture, table);
        const std::vector<float> results =
            device_->run("#version 430\nlayout(local_size_x = 64) in;\n"
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
                             "    results[3u * i + 2u] = result.b;\n}\n",
                         pairs, {count, 3});
        glDeleteTextures(1, &texture);
        return results;
    }

    /// The colour of one point drawn by a program of the technique lut, whose table's second axis is the uniform `rows`
    /// if it has any. All is black but for a white environment, so that the colour is F.
    std::array<float, 4> draw(const emit::lut& table, const std::string& vertex, const std::string& fragment,
                              float cos_i, float by = 0, const char* rows = "") const {
        const GLuint program = linked(vertex, fragment);
        glUseProgram(program);
        GLuint textures[3], framebuffer = 0, target = 0, nothing = 0;
        glGenTextures(3, textures);
        upload(textures[0], table);
        upload_surface(textures[1], textures[2]);
        set_uniforms(program, table, cos_i);
        glUniform1f(glGetUniformLocation(program, rows), by);
        glGenRenderbuffers(1, &target);
        glBindRenderbuffer(GL_RENDERBUFFER, target);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, 1, 1);
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
        glGenVertexArrays(1, &nothing);
        glBindVertexArray(nothing);
        glViewport(0, 0, 1, 1);
        glDrawArrays(GL_POINTS, 0, 1);
        std::array<float, 4> color{};
        glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, color.data());
        const GLenum error = glGetError();
        glDeleteVertexArrays(1, &nothing);
        glDeleteFramebuffers(1, &framebuffer);
        glDeleteRenderbuffers(1, &target);
        glDeleteTextures(3, textures);
        glDeleteProgram(program);
        if (error != GL_NO_ERROR) throw std::runtime_error("OpenGL: error " + std::to_string(error));
        return color;
    }

private:
    static void attach(GLuint program, GLenum stage, const std::string& source) {
        const GLuint shader = glCreateShader(stage);
        const char* lines = source.c_str();
        glShaderSource(shader, 1, &lines, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }

    static GLuint linked(const std::string& vertex, const std::string& fragment) {
        const GLuint program = glCreateProgram();
        attach(program, GL_VERTEX_SHADER, vertex);
        attach(program, GL_FRAGMENT_SHADER, fragment);
        glLinkProgram(program);
        GLint good = GL_FALSE;
        glGetProgramiv(program, GL_LINK_STATUS, &good);
        std::string log(4096, '\0');
        if (good == GL_FALSE) glGetProgramInfoLog(program, 4096, nullptr, log.data());
        if (good == GL_FALSE) throw std::runtime_error(log);
        return program;
    }

    // A flat normal map on unit 1 and a white environment on unit 2.
    static void upload_surface(GLuint normals, GLuint environment) {
        const float flat[] = {0.5f, 0.5f, 1.0f}, white[] = {1.0f, 1.0f, 1.0f};
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, normals);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, 1, 1, 0, GL_RGB, GL_FLOAT, flat);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glActiveTexture(GL_TEXTURE2);
        glBindTexture(GL_TEXTURE_CUBE_MAP, environment);
        for (GLenum side = 0; side < 6; ++side)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + side, 0, GL_RGB32F, 1, 1, 0, GL_RGB, GL_FLOAT,
                         white);
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    }

    // The point lies at the origin, its normal along z.
    static void set_uniforms(GLuint program, const emit::lut& table, float cos_i) {
        const auto place = [&](const char* name) { return glGetUniformLocation(program, name); };
        const float four[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        const float three[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        glUniformMatrix4fv(place("model_view_projection"), 1, GL_FALSE, four);
        glUniformMatrix4fv(place("model_matrix"), 1, GL_FALSE, four);
        glUniformMatrix3fv(place("normal_matrix"), 1, GL_FALSE, three);
        glUniform3f(place("eye_position"), std::sqrt(1 - cos_i * cos_i), 0, cos_i);
        glUniform2f(place("table_size"), static_cast<float>(table.columns), static_cast<float>(table.rows));
        if (table.subject.by)
            glUniform2f(place("table_range"), static_cast<float>(table.subject.by->lo),
                        static_cast<float>(table.subject.by->hi));
        glUniform1i(place("normal_map"), 1);
        glUniform1i(place("environment"), 2);
        glUniform1i(place("base_map"), 3);
        const auto attribute = [&](const char* name, float x, float z, float w) {
            const GLint at = glGetAttribLocation(program, name);
            if (at >= 0) glVertexAttrib4f(static_cast<GLuint>(at), x, 0, z, w);
        };
        attribute("position", 0, 0, 1);
        attribute("normal", 0, 1, 1);
        attribute("tangent", 1, 0, 1);
        attribute("texcoord", 0, 0, 1);
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

    std::unique_ptr<render::compute_device> device_ = render::open_opengl();
};

} // namespace fresnel::test
