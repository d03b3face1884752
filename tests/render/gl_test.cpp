#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <vector>

#include "render/gl/canvas.h"
#include "render/gl/draw_state.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"
#include "render/gl/shader_text.h"
#include "render/gl/target.h"
#include "render/gl/texture.h"
#include "render/passes/screen.h"
#include "tests/render/pass_studio.h"

namespace kaori::gl {
namespace {

constexpr ShaderFile kFiles[] = {
    {"light.glsl", "float Twice(float x) { return 2.0 * x; }\n"},
    {"good.vert", "#include \"light.glsl\"\nvoid main() { gl_Position = vec4(Twice(0.5)); }\n"},
    {"good.frag", "layout(location = 0) out vec4 colour;\nvoid main() { colour = vec4(1.0); }\n"},
    {"bad.frag", "#include \"light.glsl\"\nvoid main() {\n  wrong = 1.0;\n}\n"},
    {"whole.vert",
     "void main() {\n"
     "  gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID >> 1) * 4.0 - 1.0, 0.0, "
     "1.0);\n"
     "}\n"},
    {"level.frag",
     "uniform sampler2D picture;\nuniform int level;\nlayout(location = 0) out vec4 colour;\n"
     "void main() { colour = texelFetch(picture, ivec2(gl_FragCoord.xy), level); }\n"},
    {"plain.frag",
     "uniform vec3 light;\nlayout(location = 0) out vec4 colour;\nvoid main() { colour = vec4(light, 1.0); "
     "}\n"},
    {"lost.frag", "#include \"nowhere.glsl\"\n"}};

// The painter's context is current while any test of this program runs.
class Gl : public ::testing::Test {
 protected:
  void SetUp() override { tests::PassStudio::Shared(); }
};

TEST_F(Gl, OpensWithoutAScreen) {
  EXPECT_FALSE(tests::PassStudio::Shared().context().renderer().empty());
}

TEST_F(Gl, CompilesWhatItIncludes) {
  const auto program = Program::Make({.library = kFiles, .vertex = "good.vert", .fragment = "good.frag"});
  EXPECT_TRUE(program) << program.error().message();
}

TEST_F(Gl, NamesTheFileAndTheLineOfAFault) {
  const auto program = Program::Make({.library = kFiles, .vertex = "good.vert", .fragment = "bad.frag"});
  ASSERT_FALSE(program);
  EXPECT_NE(program.error().message().find("bad.frag:3"), std::string::npos) << program.error().message();
}

TEST_F(Gl, NamesAFileThatIsMissing) {
  const auto program = Program::Make({.library = kFiles, .vertex = "good.vert", .fragment = "lost.frag"});
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().cause, std::errc::no_such_file_or_directory);
  EXPECT_NE(program.error().attempt.find("nowhere.glsl"), std::string::npos);
}

TEST_F(Gl, ReadsTheLogsOfOtherDriversToo) {
  const std::vector<std::string_view> files{"a.frag", "b.glsl"};
  EXPECT_EQ(NameFiles("ERROR: 1:12: 'x' : undeclared\n0:3(1): error: no\n", files),
            "b.glsl:12: 'x' : undeclared; a.frag:3(1): error: no");
  EXPECT_EQ(NameFiles("1(3) : error C1503: undefined variable \"x\"\n0(no line\n", files),
            "b.glsl:3: error C1503: undefined variable \"x\"; 0(no line");
}

TEST_F(Gl, RefusesACanvasOfNoSizeOrOfAnImpossibleOne) {
  for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {1 << 20, 10}}) {
    const auto canvas = Canvas::Make({.width_px = width, .height_px = height});
    ASSERT_FALSE(canvas);
    EXPECT_EQ(canvas.error().cause, std::errc::invalid_argument);
  }
}

// Draws one colour, linear light, on all of the canvas's picture.
void Fill(const Canvas& canvas, const glm::vec3& light) {
  const auto program = Program::Make({.library = kFiles, .vertex = "whole.vert", .fragment = "plain.frag"});
  ASSERT_TRUE(program) << program.error().message();
  canvas.BeginPicture();
  canvas.Within(canvas.whole());
  Apply({.depth = Depth::kOff});
  program->Use();
  Program::Set(program->Find("light"), light);
  Mesh({}, 3).Draw();
}

TEST_F(Gl, CodesThePictureAsSrgb) {
  const auto canvas = Canvas::Make({.width_px = 2, .height_px = 2});
  ASSERT_TRUE(canvas) << canvas.error().message();
  Fill(*canvas, {0.5F, 0, 1});
  std::vector<std::uint8_t> bytes(16);
  canvas->ReadPixels(bytes);
  EXPECT_NEAR(bytes[0], 188, 1);
  EXPECT_EQ(bytes[1], 0);
  EXPECT_EQ(bytes[2], 255);
}

// The bytes that `draw` leaves on a target of bytes, which are stored as they are.
template <class Draw>
std::vector<std::uint8_t> Codes(int width_px, int height_px, Draw draw) {
  const auto target = Target::Make({.width_px = width_px, .height_px = height_px});
  target->Begin();
  draw();
  std::vector<std::uint8_t> bytes(4 * static_cast<std::size_t>(width_px) *
                                  static_cast<std::size_t>(height_px));
  glReadPixels(0, 0, width_px, height_px, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

TEST_F(Gl, MakesEachSmallerPictureOfFourTexelsMeans) {
  constexpr std::array<std::uint8_t, 4 * 2 * 4> kTexels{10, 0, 0, 0, 20, 0, 0, 0, 90, 0, 0, 8, 90, 0, 0, 8,
                                                        30, 0, 0, 0, 40, 0, 0, 0, 90, 0, 0, 8, 94, 0, 0, 8};
  const auto texels = std::as_bytes(std::span(kTexels));
  const Texture texture({.width_px = 4, .height_px = 2, .mipmaps = true},
                        MipLevelsOf({texels.begin(), texels.end()}, 4, 2));
  const auto program = Program::Make({.library = kFiles, .vertex = "whole.vert", .fragment = "level.frag"});
  ASSERT_TRUE(program) << program.error().message();
  const Mesh everywhere({}, 3);
  const auto level = [&](int number) {
    Apply({.depth = Depth::kOff});
    program->BindSampler("picture", 0);
    Program::Set(program->Find("level"), number);
    texture.Bind(0);
    everywhere.Draw();
  };
  const auto half = Codes(2, 1, [&] { level(1); });
  EXPECT_EQ(half[0], 25);
  EXPECT_EQ(half[4], 91);
  const auto last = Codes(1, 1, [&] { level(2); });
  EXPECT_EQ(last[0], 58);
}

TEST_F(Gl, ShowsThePictureOnAScreenBitByBit) {
  auto screen = passes::ScreenPass::Open();
  ASSERT_TRUE(screen) << screen.error().message();
  const auto canvas = Canvas::Make({.width_px = 2, .height_px = 2});
  ASSERT_TRUE(canvas) << canvas.error().message();
  for (float light = 0; light <= 1; light += 1.0F / 64) {
    Fill(*canvas, {light, light / 2, light / 8});
    std::vector<std::uint8_t> bytes(16);
    canvas->ReadPixels(bytes);
    const auto shown = Codes(2, 2, [&] { screen->Draw(*canvas, 0); });
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(shown[i], bytes[i]) << light;
  }
}

}  // namespace
}  // namespace kaori::gl
