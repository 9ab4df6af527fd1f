#include "render/compute.hpp"

#include "error.hpp"
#include "render/unwatched.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <fmt/format.h>

#include <cstdlib>

namespace fresnel::render {

namespace {

/// A shader, program or buffer, deleted at the end of its scope.
class handle {
public:
    using deleter = void (*)(GLuint);
    handle(GLuint id, deleter destroy) : id_(id), destroy_(destroy) {}
    ~handle() { destroy_(id_); }
    handle(const handle&) = delete;
    handle& operator=(const handle&) = delete;
    operator GLuint() const { return id_; }

private:
    GLuint id_;
    deleter destroy_;
};

GLuint new_buffer() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
}

void delete_buffer(GLuint id) { glDeleteBuffers(1, &id); }

class opengl final : public compute_device {
public:
    opengl() {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
        if (!epoxy_has_egl()) throw no_device("there is no EGL library");
        if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
            throw no_device("EGL cannot do without a screen (EGL_MESA_platform_surfaceless)");
        display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE)
            throw no_device("EGL finds no device; libgl1-mesa-dri has a software one");
        const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
        if (eglBindAPI(EGL_OPENGL_API) != EGL_FALSE)
            context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
        if (context_ == EGL_NO_CONTEXT ||
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
            eglTerminate(display_);
            throw no_device("the device has no OpenGL 4.3");
        }
    }

    ~opengl() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglTerminate(display_);
    }

    std::string name() const override {
        return fmt::format("{}, OpenGL {}", text(GL_RENDERER), text(GL_VERSION));
    }

    std::vector<float> run(const std::string& shader, std::span<const float> inputs,
                           const evaluation& how) override {
        const unwatched driver;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
        const handle program = link(shader);
        const handle in(new_buffer(), delete_buffer), out(new_buffer(), delete_buffer);
        std::vector<float> results(how.rows * how.results);
        bind(in, 0, inputs.data(), inputs.size_bytes());
        bind(out, 1, nullptr, results.size() * sizeof(float));
        glUseProgram(program);
        glDispatchCompute(static_cast<GLuint>((how.rows + 63) / 64), 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
                           static_cast<GLsizeiptr>(results.size() * sizeof(float)), results.data());
        if (const GLenum error = glGetError(); error != GL_NO_ERROR)
            throw failure(fmt::format("OpenGL: error {:#x} while a shader ran", error));
        return results;
    }

private:
    static std::string text(GLenum what) { return reinterpret_cast<const char*>(glGetString(what)); }

    static void bind(GLuint buffer, GLuint binding, const void* data, std::size_t bytes) {
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
        glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_READ);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
    }

    static handle link(const std::string& source) {
        const handle shader(glCreateShader(GL_COMPUTE_SHADER), [](GLuint id) { glDeleteShader(id); });
        const char* lines = source.c_str();
        glShaderSource(shader, 1, &lines, nullptr);
        glCompileShader(shader);
        GLint good = GL_FALSE;
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
        if (good == GL_FALSE) {
            glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
            throw refused_shader(log.substr(0, static_cast<std::size_t>(length)));
        }
        const GLuint program = glCreateProgram();
        glAttachShader(program, shader);
        glLinkProgram(program);
        glDetachShader(program, shader);
        glGetProgramiv(program, GL_LINK_STATUS, &good);
        if (good == GL_FALSE) {
            glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
            glDeleteProgram(program);
            throw refused_shader(log.substr(0, static_cast<std::size_t>(length)));
        }
        return handle(program, [](GLuint id) { glDeleteProgram(id); });
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

} // namespace

std::unique_ptr<compute_device> open_opengl() {
    const unwatched driver;
    return std::make_unique<opengl>();
}

} // namespace fresnel::render
