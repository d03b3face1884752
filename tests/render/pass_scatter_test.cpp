// Light within skin: it is spread beside where it falls, on the surface on which it falls, and nowhere else.
#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <array>
#include <span>

#include "render/gl/buffer.h"
#include "render/gl/draw_state.h"
#include "render/gl/mesh.h"
#include "render/gl/target.h"
#include "render/passes/frame.h"
#include "render/passes/scatter.h"
#include "tests/render/pass_studio.h"

namespace kaori {
namespace {

constexpr int kScatterSide_px = 64, kScatterEdge_px = 32;
constexpr float kScatterAt_m = 0.5F;
// So high that a pixel is a third of a millimetre: what is spread reaches over several of them.
constexpr glm::vec2 kSeenLarge_px{1024, 1024};

constexpr std::array<gl::ShaderFile, 2> kReadFiles{
    {{"all.vert",
      "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n"},
     {"read.frag",
      "uniform sampler2D scattered;\nlayout(location = 0) out vec4 colour;\n"
      "void main() { colour = texelFetch(scattered, ivec2(gl_FragCoord.xy), 0); }\n"}}};

// One half of a picture.
struct Half {
  float light;
  float away_m;  // 0: no skin.
};

class ScatterTest : public ::testing::Test {
 protected:
  // Red, green, blue and metres, 0..255, of the middle row.
  using Row = std::array<std::array<std::uint8_t, 4>, kScatterSide_px>;

  void SetUp() override { tests::PassStudio::Shared(); }

  static void Fill(int left_px, const Half& half) {
    glScissor(left_px, 0, kScatterEdge_px, kScatterSide_px);
    glClearColor(half.light, half.light, half.light, half.away_m);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  static Row Read(const passes::ScatterPass& pass) {
    const auto program =
        gl::Program::Make({.library = kReadFiles, .vertex = "all.vert", .fragment = "read.frag"});
    EXPECT_TRUE(program) << program.error().message();
    const auto target = gl::Target::Make({.width_px = kScatterSide_px, .height_px = kScatterSide_px});
    target->Begin();
    gl::Apply({.depth = gl::Depth::kOff});
    pass.Bind(0);
    program->Use();
    gl::Mesh({}, 3).Draw();
    Row row;
    glReadPixels(0, kScatterSide_px / 2, kScatterSide_px, 1, GL_RGBA, GL_UNSIGNED_BYTE, row.data());
    return row;
  }
  // What comes out of skin that is lit so at its left and at its right.
  static Row Spread(const Half& left, const Half& right) {
    auto pass = passes::ScatterPass::Open();
    EXPECT_TRUE(pass) << pass.error().message();
    EXPECT_TRUE(pass->Begin(kScatterSide_px, kScatterSide_px, {0, 0, kScatterSide_px, kScatterSide_px}));
    Fill(0, left);
    Fill(kScatterEdge_px, right);
    const passes::FrameBlock block =
        passes::MakeFrame(tests::PlainScene(scene::Style::kSoft),
                          passes::NeckOf(tests::PassStudio::Shared().cast()), kSeenLarge_px, 1);
    gl::Buffer frame(gl::BufferUse::kStatic, sizeof(block));
    frame.Write(std::as_bytes(std::span(&block, 1)));
    frame.BindUniforms(passes::kFrameBinding);
    pass->Spread();
    return Read(*pass);
  }
};

TEST_F(ScatterTest, RedGoesFarthestIntoTheShade) {
  const Row row = Spread({1, kScatterAt_m}, {0, kScatterAt_m});
  const auto& shade = row[kScatterEdge_px + 3];
  EXPECT_GT(shade[0], shade[1] + 10);
  EXPECT_GT(shade[1], shade[2]);
  EXPECT_GT(row[kScatterEdge_px][2], 20) << "blue comes out close by";
}

TEST_F(ScatterTest, LosesNoLight) {
  const Row row = Spread({1, kScatterAt_m}, {0, kScatterAt_m});
  for (int px = 0; px < kScatterEdge_px; ++px)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(row[static_cast<std::size_t>(kScatterEdge_px + px)][c] +
                      row[static_cast<std::size_t>(kScatterEdge_px - 1 - px)][c],
                  255, 3)
          << px << " pixels from the edge";
}

TEST_F(ScatterTest, StaysOnTheSurfaceOnWhichItFalls) {
  const Row row = Spread({1, kScatterAt_m}, {0, kScatterAt_m + 0.02F});
  EXPECT_GE(row[kScatterEdge_px - 1][0], 254);
  EXPECT_LE(row[kScatterEdge_px][0], 1);
}

TEST_F(ScatterTest, LeavesAloneWhatIsNoSkin) {
  const Row row = Spread({1, kScatterAt_m}, {1, 0});
  EXPECT_GE(row[kScatterEdge_px - 1][2], 254);
  EXPECT_EQ(row[kScatterEdge_px][3], 0);
}

}  // namespace
}  // namespace kaori
