#include "render/gl/context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl32.h>

#include <array>

#include "drivers/base/log.h"

namespace kaori::gl {

struct Context::Egl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  ~Egl() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }
};

namespace {

EGLDisplay SurfacelessDisplay() {
  const auto get =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get == nullptr) return EGL_NO_DISPLAY;
  return get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

EGLContext NewContext(EGLDisplay display, bool debug) {
  constexpr std::array config_wish{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT,
                                   EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, config_wish.data(), &config, 1, &count) || count == 0) return EGL_NO_CONTEXT;
  const std::array context_wish{EGL_CONTEXT_MAJOR_VERSION,
                                3,
                                EGL_CONTEXT_MINOR_VERSION,
                                0,
                                EGL_CONTEXT_OPENGL_DEBUG,
                                int{debug},
                                EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, context_wish.data());
}

#ifndef NDEBUG
constexpr bool kDebug = true;
#else
constexpr bool kDebug = false;
#endif

void GL_APIENTRY LogMessage(GLenum, GLenum, GLuint, GLenum severity, GLsizei, const GLchar* text,
                            const void*) {
  if (severity != GL_DEBUG_SEVERITY_NOTIFICATION) Log("GL: {}", text);
}

// Debug output is GLES 3.2 or KHR_debug; without either the driver keeps its remarks to itself.
void ListenToDriver() {
  const auto listen =
      reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKPROC>(eglGetProcAddress("glDebugMessageCallbackKHR"));
  if (listen == nullptr) return;
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  listen(LogMessage, nullptr);
}

}  // namespace

Context::Context(std::unique_ptr<Egl> egl)
    : egl_(std::move(egl)), renderer_(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) {}

Context::~Context() = default;

bool Context::ReadsSamples() {
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  return major > 3 || (major == 3 && minor >= 1);
}

Result<std::unique_ptr<Context>> Context::Open() {
  auto egl = std::make_unique<Egl>();
  egl->display = SurfacelessDisplay();
  if (egl->display == EGL_NO_DISPLAY || !eglInitialize(egl->display, nullptr, nullptr)) {
    return Fail(std::errc::no_such_device, "open EGL's surfaceless platform");
  }
  eglBindAPI(EGL_OPENGL_ES_API);
  egl->context = NewContext(egl->display, kDebug);
  if (egl->context == EGL_NO_CONTEXT) return Fail(std::errc::no_such_device, "make a GLES 3 context");
  if (!eglMakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context)) {
    return Fail(std::errc::protocol_error, "make the GLES context current");
  }
  if (kDebug) ListenToDriver();
  return std::unique_ptr<Context>(new Context(std::move(egl)));
}

}  // namespace kaori::gl
