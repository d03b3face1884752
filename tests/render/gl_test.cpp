#include <gtest/gtest.h>

#include <vector>

#include "render/gl/canvas.h"
#include "render/gl/program.h"
#include "render/gl/shader_text.h"
#include "tests/render/pass_studio.h"

namespace kaori::gl {
namespace {

constexpr ShaderFile kFiles[] = {
    {"light.glsl", "float Twice(float x) { return 2.0 * x; }\n"},
    {"good.vert", "#include \"light.glsl\"\nvoid main() { gl_Position = vec4(Twice(0.5)); }\n"},
    {"good.frag", "layout(location = 0) out vec4 colour;\nvoid main() { colour = vec4(1.0); }\n"},
    {"bad.frag", "#include \"light.glsl\"\nvoid main() {\n  wrong = 1.0;\n}\n"},
    {"lost.frag", "#include \"nowhere.glsl\"\n"}};

// The painter's context is current while any test of this program runs.
class Gl : public ::testing::Test {
 protected:
  void SetUp() override { testing::PassStudio::Shared(); }
};

TEST_F(Gl, OpensWithoutAScreen) {
  EXPECT_FALSE(testing::PassStudio::Shared().context().renderer().empty());
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
}

TEST_F(Gl, RefusesACanvasOfNoSizeOrOfAnImpossibleOne) {
  for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {1 << 20, 10}}) {
    const auto canvas = Canvas::Make({.width_px = width, .height_px = height});
    ASSERT_FALSE(canvas);
    EXPECT_EQ(canvas.error().cause, std::errc::invalid_argument);
  }
}

TEST_F(Gl, CodesTheBackgroundAsSrgb) {
  const auto canvas = Canvas::Make({.width_px = 2, .height_px = 2, .samples = 0});
  ASSERT_TRUE(canvas) << canvas.error().message();
  canvas->BeginPlain({0.5F, 0, 1});
  std::vector<std::uint8_t> bytes(16);
  canvas->ReadPixels(bytes);
  EXPECT_NEAR(bytes[0], 188, 1);
  EXPECT_EQ(bytes[1], 0);
  EXPECT_EQ(bytes[2], 255);
}

TEST_F(Gl, TakesCodesAsTheyAreWhereAsked) {
  const auto canvas = Canvas::Make({.width_px = 2, .height_px = 2, .samples = 0, .takes_codes = true});
  ASSERT_TRUE(canvas) << canvas.error().message();
  canvas->BeginPlain({0.5F, 0, 1});
  std::vector<std::uint8_t> bytes(16);
  canvas->ReadPixels(bytes);
  EXPECT_NEAR(bytes[0], 128, 1);
  EXPECT_EQ(bytes[2], 255);
}

}  // namespace
}  // namespace kaori::gl
