#include "render/gl/context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl32.h>

#include <array>
#include <span>

#include "drivers/base/log.h"

namespace kaori::gl {

// What EGL gave, given back in reverse; whatever is missing was never had.
struct Context::Egl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLConfig config = nullptr;
  EGLContext context = EGL_NO_CONTEXT;

  // The context must not be current when it goes.
  ~Egl() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }
};

namespace {

// Of the pixels that every CRTC scans out; the number is GBM's and DRM's "XR24".
constexpr EGLint kScreenPixels = 0x34325258;

template <class Function>
Function Get(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

// Null where EGL does not have the platform, or its driver does not start.
EGLDisplay Started(EGLenum platform, void* native) {
  const auto get = Get<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  const EGLDisplay display = get == nullptr ? EGL_NO_DISPLAY : get(platform, native, nullptr);
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

// The first device that starts (EGL_EXT_device_enumeration, EGL_EXT_platform_device).
EGLDisplay AnyDevice() {
  const auto query = Get<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (query == nullptr || !query(EGLint{devices.size()}, devices.data(), &count)) return EGL_NO_DISPLAY;
  for (EGLDeviceEXT device : std::span(devices).first(std::size_t(count)))
    if (EGLDisplay display = Started(EGL_PLATFORM_DEVICE_EXT, device); display != EGL_NO_DISPLAY)
      return display;
  return EGL_NO_DISPLAY;
}

// A display of the card; or of no screen, which is EGL_MESA_platform_surfaceless, and where a driver does not
// have that, as some of other makers, its device.
EGLDisplay DisplayOf(void* gbm) {
  if (gbm != nullptr) return Started(EGL_PLATFORM_GBM_KHR, gbm);
  EGLDisplay display = Started(EGL_PLATFORM_SURFACELESS_MESA, nullptr);
  return display != EGL_NO_DISPLAY ? display : AnyDevice();
}

// The first of those with GLES 3; for a card, one whose windows hold what a screen shows. Null where there is
// none.
EGLConfig ChooseConfig(EGLDisplay display, bool for_card) {
  const std::array wish{EGL_SURFACE_TYPE, for_card ? EGL_WINDOW_BIT : EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                        EGL_OPENGL_ES3_BIT, EGL_NONE};
  std::array<EGLConfig, 64> configs{};
  EGLint count = 0;
  // In an order of EGL's own, the simplest first.
  if (!eglChooseConfig(display, wish.data(), configs.data(), EGLint{configs.size()}, &count)) return nullptr;
  for (const EGLConfig config : std::span(configs).first(std::size_t(count))) {
    EGLint pixels = 0;
    eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &pixels);
    if (!for_card || pixels == kScreenPixels) return config;
  }
  return nullptr;
}

// Any GLES 3; drivers give the newest that they have.
EGLContext NewContext(EGLDisplay display, EGLConfig config, bool debug) {
  // The flag as the extension writes it: EGL 1.4, as on a card without a GPU, does not know EGL 1.5's.
  const std::array context_wish{EGL_CONTEXT_MAJOR_VERSION_KHR,
                                3,
                                EGL_CONTEXT_MINOR_VERSION_KHR,
                                0,
                                EGL_CONTEXT_FLAGS_KHR,
                                debug ? EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR : 0,
                                EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, context_wish.data());
}

#ifndef NDEBUG
// Builds without NDEBUG ask the driver for its messages.
constexpr bool kDebug = true;
#else
constexpr bool kDebug = false;
#endif

// What drivers merely notice is left out: there is much of it.
// NOLINTNEXTLINE(readability-function-size): the parameters are GL's.
void GL_APIENTRY LogMessage(GLenum, GLenum, GLuint, GLenum severity, GLsizei, const GLchar* text,
                            const void*) {
  if (severity != GL_DEBUG_SEVERITY_NOTIFICATION) LogWarning("GL: {}", text);
}

// Debug output is GLES 3.2 or KHR_debug; without either the driver keeps its remarks to itself.
void ListenToDriver() {
  const auto listen = Get<PFNGLDEBUGMESSAGECALLBACKPROC>("glDebugMessageCallbackKHR");
  if (listen == nullptr) return;
  // Synchronous, so that a debugger's stack shows the call that was wrong.
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  listen(LogMessage, nullptr);
}

}  // namespace

Context::Context(std::unique_ptr<Egl> egl)
    : egl_(std::move(egl)), renderer_(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) {}

Context::~Context() = default;

void* Context::display() const {
  return egl_->display;
}
void* Context::config() const {
  return egl_->config;
}
void* Context::handle() const {
  return egl_->context;
}

// GLES 3.1 has textures with samples (GL_TEXTURE_2D_MULTISAMPLE).
bool Context::ReadsSamples() {
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (major < 3 || (major == 3 && minor < 1)) return false;
  GLint most = 0;
  glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &most);
  return most >= 4;
}

// GLES 3 lists extensions one by one; names are compared whole, since some begin like others.
bool Context::Offers(std::string_view extension) {
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  // Asked when something is made, never in a frame.
  for (GLint i = 0; i < count; ++i)
    if (extension == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))))
      return true;
  return false;
}

// Without a surface (EGL_KHR_surfaceless_context): drawing goes to framebuffer objects, and to windows when
// they are begun.
Result<std::unique_ptr<Context>> Context::Open(void* gbm) {
  auto egl = std::make_unique<Egl>();
  egl->display = DisplayOf(gbm);
  if (egl->display == EGL_NO_DISPLAY) {
    return Fail(std::errc::no_such_device,
                gbm != nullptr ? "open EGL on the graphics card" : "open EGL without a screen");
  }
  // EGL's default is GLES already; other libraries in the process may have changed it.
  eglBindAPI(EGL_OPENGL_ES_API);
  egl->config = ChooseConfig(egl->display, gbm != nullptr);
  if (egl->config == nullptr) return Fail(std::errc::no_such_device, "find a way to draw GLES 3");
  egl->context = NewContext(egl->display, egl->config, kDebug);
  if (egl->context == EGL_NO_CONTEXT) return Fail(std::errc::no_such_device, "make a GLES 3 context");
  if (!eglMakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context)) {
    return Fail(std::errc::protocol_error, "make the GLES context current");
  }
  if (kDebug) ListenToDriver();
  return std::unique_ptr<Context>(new Context(std::move(egl)));
}

}  // namespace kaori::gl
