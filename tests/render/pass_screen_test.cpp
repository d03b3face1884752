// The copy of the picture to a screen's window: whole where nothing is known, else what has changed.
#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "render/gl/damage.h"
#include "render/gl/target.h"
#include "render/passes/screen.h"
#include "tests/render/pass_studio.h"

namespace kaori {
namespace {

constexpr int kScreenWidth_px = 160, kScreenHeight_px = 90;

int Area(const gl::Damage& damage) {
  int area_px = 0;
  for (const gl::Box& box : damage.boxes()) area_px += box.empty() ? 0 : box.width_px * box.height_px;
  return area_px;
}

TEST(Damage, IsTheRowsThatABoxTouchesFromItsLeftToItsRight) {
  gl::Damage damage(100, 200);
  EXPECT_EQ(Area(damage), 0);
  damage.Add({10, 15, 30, 10});  // Rows of ten pixels: it touches two.
  EXPECT_EQ(Area(damage), 30 * 20);
  damage.Add({60, 15, 5, 1});
  EXPECT_EQ(Area(damage), 55 * 10 + 30 * 10);
  damage.Add({-50, -50, 20, 400});
  EXPECT_EQ(Area(damage), 55 * 10 + 30 * 10) << "it lies beside the picture";
  gl::Damage of_another_size(50, 50);
  damage.Add(of_another_size);
  EXPECT_EQ(Area(damage), 100 * 200);
}

// Windows as a screen has them: buffers that are drawn on in turns, and remember.
class Windows {
 public:
  explicit Windows(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      buffers_.push_back(
          std::move(*gl::Target::Make({.width_px = kScreenWidth_px, .height_px = kScreenHeight_px})));
  }
  // Draws as the next picture, and gives what the window shows then.
  std::vector<std::uint8_t> Show(passes::ScreenPass& pass, const gl::Canvas& canvas) {
    const auto count = static_cast<int>(buffers_.size());
    const gl::Target& buffer = buffers_[static_cast<std::size_t>(shown_ % count)];
    buffer.Begin();
    pass.Draw(canvas, shown_ < count ? 0 : count);
    ++shown_;
    return Read(buffer);
  }
  // Spoils a pixel of the buffer that is shown `pictures` from now.
  void Spoil(int pictures, int x_px, int y_px) {
    const auto next = static_cast<std::size_t>((shown_ + pictures) % static_cast<int>(buffers_.size()));
    buffers_[next].Begin();
    glEnable(GL_SCISSOR_TEST);
    glScissor(x_px, y_px, 1, 1);
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }

 private:
  static std::vector<std::uint8_t> Read(const gl::Target& target) {
    std::vector<std::uint8_t> bytes(std::size_t{kScreenWidth_px} * kScreenHeight_px * 4);
    target.ReadPixels(bytes);
    return bytes;
  }
  std::vector<gl::Target> buffers_;
  int shown_ = 0;
};

// Every way in which a picture changes: the head turns and leaves, a caption comes and goes, light and backdrop
// change, another style is drawn.
scene::Scene Changing(int picture) {
  scene::Scene scene = tests::PlainScene(picture % 11 == 10 ? scene::Style::kWire : scene::Style::kSoft);
  scene.camera.distance_m *= 1.6F;
  scene.head.yaw_rad = 0.5F * static_cast<float>(picture % 7 - 3) / 3;
  scene.head.shift_m.x = 0.05F * static_cast<float>(picture % 5 - 2);
  if (picture % 9 == 4) scene.caption = {.shown = 1, .lines = {"Good evening"}};
  if (picture % 13 > 9) scene.light.exposure = 0.5F;
  if (picture > 20) scene.backdrop.kind = scene::BackdropKind::kCurtain;
  if (picture % 17 == 16) scene.present = 0;
  return scene;
}

int Wrong(const std::vector<std::uint8_t>& shown, const std::vector<std::uint8_t>& drawn) {
  int wrong = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) wrong += i % 4 != 3 && shown[i] != drawn[i] ? 1 : 0;
  return wrong;
}

TEST(Screen, ShowsEveryPictureWholeThoughItCopiesWhatHasChanged) {
  auto& studio = tests::PassStudio::Shared();
  for (const std::size_t buffers : {1U, 2U, 3U}) {
    auto pass = passes::ScreenPass::Open();
    ASSERT_TRUE(pass) << pass.error().message();
    const auto canvas = gl::Canvas::Make({.width_px = kScreenWidth_px, .height_px = kScreenHeight_px});
    ASSERT_TRUE(canvas) << canvas.error().message();
    Windows windows(buffers);
    for (int picture = 0; picture < 40; ++picture) {
      const auto drawn = studio.DrawOn(*canvas, Changing(picture)).bytes;
      // Pictures that nobody is shown, as where the time of a frame is measured.
      if (picture % 6 == 5) continue;
      EXPECT_EQ(Wrong(windows.Show(*pass, *canvas), drawn), 0) << buffers << " buffers, picture " << picture;
    }
  }
}

// The control of the test above, and what is gained: a spoilt pixel of the backdrop stays, for it is not copied.
TEST(Screen, DoesNotCopyABackdropAtRest) {
  auto& studio = tests::PassStudio::Shared();
  auto pass = passes::ScreenPass::Open();
  ASSERT_TRUE(pass) << pass.error().message();
  const auto canvas = gl::Canvas::Make({.width_px = kScreenWidth_px, .height_px = kScreenHeight_px});
  Windows windows(2);
  scene::Scene scene = Changing(0);
  for (int picture = 0; picture < 4; ++picture) {
    scene.head.yaw_rad = 0.01F * static_cast<float>(picture);
    studio.DrawOn(*canvas, scene);
    windows.Show(*pass, *canvas);
  }
  windows.Spoil(0, 2, kScreenHeight_px - 2);
  scene.head.yaw_rad += 0.01F;
  auto drawn = studio.DrawOn(*canvas, scene).bytes;
  EXPECT_GT(Wrong(windows.Show(*pass, *canvas), drawn), 0) << "the corner was copied";
  windows.Spoil(0, 2, kScreenHeight_px - 2);
  pass->Forget();
  drawn = studio.DrawOn(*canvas, scene).bytes;
  EXPECT_EQ(Wrong(windows.Show(*pass, *canvas), drawn), 0) << "what may not have been shown is drawn anew";
}

}  // namespace
}  // namespace kaori
