// bare-egl: no more than a first frame of 960x540 needs, through EGL's surfaceless platform: a context, one shader,
// one triangle, read back. It ends as soon as the frame is there: 0, or 1 where the driver refused a step.
// The reference of stage.start_over_bare_egl.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <unistd.h>

#include <vector>

namespace {

constexpr int kWidth_px = 960;
constexpr int kHeight_px = 540;

constexpr const char* kVertex = R"(#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); })";
constexpr const char* kFragment = R"(#version 300 es
precision highp float;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(gl_FragCoord.xy / vec2(960.0, 540.0), 0.5, 1.0); })";

bool MakeContext() {
  const auto get =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get == nullptr) return false;
  const EGLDisplay display = get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return false;
  eglBindAPI(EGL_OPENGL_ES_API);
  constexpr EGLint kWish[]{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT,
                           EGL_NONE};
  constexpr EGLint kVersion3[]{EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, kWish, &config, 1, &count) == EGL_FALSE || count == 0) return false;
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, kVersion3);
  return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
}

void AttachShader(GLuint program, GLenum kind, const char* text) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
}

bool DrawFrame() {
  GLuint texture = 0;
  GLuint frame = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, kWidth_px, kHeight_px);
  glGenFramebuffers(1, &frame);
  glBindFramebuffer(GL_FRAMEBUFFER, frame);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  const GLuint program = glCreateProgram();
  AttachShader(program, GL_VERTEX_SHADER, kVertex);
  AttachShader(program, GL_FRAGMENT_SHADER, kFragment);
  glLinkProgram(program);
  glUseProgram(program);
  glViewport(0, 0, kWidth_px, kHeight_px);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<unsigned char> bytes(std::size_t{kWidth_px} * kHeight_px * 4);
  glReadPixels(0, 0, kWidth_px, kHeight_px, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return bytes[2] == 128 || bytes[2] == 127;  // Half of full blue: the shader has run.
}

}  // namespace

int main() {
  const bool drawn = MakeContext() && DrawFrame();
  _exit(drawn ? 0 : 1);  // The driver's end is not measured.
}
