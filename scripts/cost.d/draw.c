/* draw VERTEX FRAGMENT...
 * Links and draws with each fragment shader, on the device /dev/dri/renderD128, and prints `== FRAGMENT` and what the driver
 * says of its shaders (the messages of GL_KHR_debug). Made for a device that Mesa's drm-shim plays, where nothing is drawn. */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl32.h>
#include <fcntl.h>
#include <gbm.h>
#include <stdio.h>
#include <stdlib.h>

static void fail(const char* what, const char* why) {
    fprintf(stderr, "draw: %s: %s\n", what, why);
    exit(1);
}

static char* contents(const char* path) {
    FILE* file = fopen(path, "rb");
    if (!file) fail(path, "cannot be read");
    char* text = calloc(1, 1 << 20);
    fread(text, 1, (1 << 20) - 1, file);
    fclose(file);
    return text;
}

static void GL_APIENTRY say(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                            const GLchar* message, const void* user) {
    (void)source, (void)type, (void)id, (void)severity, (void)user;
    printf("%.*s\n", (int)length, message);
}

static EGLDisplay start(void) {
    const int file = open("/dev/dri/renderD128", O_RDWR);
    if (file < 0) fail("/dev/dri/renderD128", "cannot be opened");
    struct gbm_device* device = gbm_create_device(file);
    EGLDisplay display = device ? eglGetPlatformDisplay(EGL_PLATFORM_GBM_KHR, device, NULL) : EGL_NO_DISPLAY;
    if (!eglInitialize(display, NULL, NULL)) fail("EGL", "does not start");
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_FLAGS_KHR,
                             EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR, EGL_NONE};
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (!context || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        fail("EGL", "makes no context of OpenGL ES 3");
    return display;
}

static void make_target(void) {
    GLuint texture, target;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 16, 16);
    glGenFramebuffers(1, &target);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glViewport(0, 0, 16, 16);
}

static void attach(GLuint program, GLenum stage, const char* path) {
    const char* text = contents(path);
    char log[4096] = "";
    GLint compiled = 0;
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &text, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    if (!compiled) fail(path, log);
    glAttachShader(program, shader);
}

static void draw(const char* vertex, const char* fragment) {
    char log[4096] = "";
    GLint linked = 0;
    const GLuint program = glCreateProgram();
    attach(program, GL_VERTEX_SHADER, vertex);
    attach(program, GL_FRAGMENT_SHADER, fragment);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    glGetProgramInfoLog(program, sizeof log, NULL, log);
    if (!linked) fail(fragment, log);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFlush();
}

int main(int count, char** arguments) {
    start();
    make_target();
    glEnable(GL_DEBUG_OUTPUT);
    glDebugMessageCallback(say, NULL);
    for (int i = 2; i < count; ++i) {
        printf("== %s\n", arguments[i]);
        draw(arguments[1], arguments[i]);
    }
    return 0;
}
