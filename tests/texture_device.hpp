#pragma once

// Reads a texture by a compute shader on OpenGL's device.

#include "emit/lut.hpp"
#include "render/compute.hpp"

#include <epoxy/gl.h>

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

private:
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
