#include "appliance/programs/stage/studio.h"

#include <algorithm>

namespace kaori::stage {

Result<std::unique_ptr<Studio>> Studio::Open(show::Show show, void* gbm) {
  auto context = gl::Context::Open(gbm);
  if (!context) return tl::unexpected(context.error());
  return Open(std::make_unique<PreparedShow>(std::move(show)), std::move(*context));
}

// The studio exists before its painter, which borrows its cast.
Result<std::unique_ptr<Studio>> Studio::Open(std::unique_ptr<PreparedShow> prepared,
                                             std::unique_ptr<gl::Context> context) {
  std::unique_ptr<Studio> studio(new Studio(std::move(context), std::move(prepared)));
  PreparedShow& made_of = *studio->prepared_;
  auto painter =
      passes::Painter::Open(*studio->context_, made_of.show_.cast, std::move(made_of.preparation_));
  if (!painter) return tl::unexpected(painter.error());
  studio->painter_ = std::move(*painter);
  return studio;
}

Result<void> Studio::Resize(int width_px, int height_px) {
  const gl::Antialiasing wanted = painter_->antialiasing();
  const bool fits = canvas_.width_px() == width_px && canvas_.height_px() == height_px;
  if (fits && canvas_.antialiasing() == wanted) return {};
  auto canvas = gl::Canvas::Make({.width_px = width_px, .height_px = height_px, .antialiasing = wanted});
  if (!canvas) return tl::unexpected(canvas.error());
  canvas_ = std::move(*canvas);
  return {};
}

// What was readied of the other quality is to be readied again.
Result<void> Studio::SetQuality(passes::Quality quality) {
  auto set = painter_->SetQuality(quality);
  if (set) unprepared_ = true;
  return set;
}

// The picture is read back small, which waits for all of it.
Result<Duration> Studio::TimeFrame(const scene::Scene& scene, int width_px, int height_px) {
  constexpr int kGlance_px = 32;
  if (auto resized = Resize(width_px, height_px); !resized) return tl::unexpected(resized.error());
  const SteadyClock clock;
  const Time begun = clock.now();
  painter_->Draw(scene, canvas_);
  SmallImage glance;
  ReadSmall(kGlance_px, glance);
  return clock.now() - begun;
}

// Drawing always goes to the canvas, which then is copied out: into the screen's memory, or by one more pass
// into its window. So the picture of the last face can be read from it whatever the screen is.
Result<void> Studio::Draw(const scene::Scene& scene, const ports::PixelBuffer& picture) {
  drew_ = asked_++ % one_of_ == 0;
  if (!drew_) return {};
  if (auto resized = Resize(picture.width_px, picture.height_px); !resized) return resized;
  painter_->Draw(scene, canvas_);
  if (const auto* egl = std::get_if<ports::EglSurface>(&picture.target)) return ShowIn(egl->surface);
  canvas_.ReadPixels(picture.memory());
  return {};
}

// The window is made when its first picture comes, since only the screen knows it; so is the pass that
// copies.
Result<void> Studio::ShowIn(void* window) {
  if (window_.native() != window) {
    CloseWindow();
    auto made = gl::Window::Make(*context_, window);
    if (!made) return tl::unexpected(made.error());
    window_ = std::move(*made);
  }
  if (!screen_pass_) {
    auto pass = passes::ScreenPass::Open();
    if (!pass) return tl::unexpected(pass.error());
    screen_pass_.emplace(std::move(*pass));
  }
  if (auto begun = window_.Begin(canvas_.width_px(), canvas_.height_px()); !begun) return begun;
  screen_pass_->Draw(canvas_, window_.PicturesAgo());
  auto shown = window_.Show();
  if (!shown) screen_pass_->Forget();
  return shown;
}

// Scaled on the graphics card, so that few bytes are read back; the height follows the canvas's proportions.
bool Studio::ReadSmall(int most_width_px, SmallImage& into) {
  if (canvas_.width_px() == 0) return false;
  const int width_px = std::min(most_width_px, canvas_.width_px());
  const int height_px = std::max(1, canvas_.height_px() * width_px / canvas_.width_px());
  if (!small_ || small_->width_px() != width_px || small_->height_px() != height_px) {
    auto small =
        gl::Target::Make({.width_px = width_px, .height_px = height_px, .texels = gl::Texels::kSrgb8});
    if (!small) return false;
    small_.emplace(std::move(*small));
  }
  into.width_px = width_px;
  into.height_px = height_px;
  into.pixels.resize(std::size_t(width_px) * std::size_t(height_px) * 4);
  canvas_.ShrinkTo(*small_);
  small_->ReadPixels(into.pixels);
  return true;
}

// The first one makes the target, and so does another size.
void Studio::AskPicture(int most_width_px, int most_height_px) {
  if (canvas_.width_px() == 0 || readback_.pending()) return;
  const double scale = std::min(
      {1.0, double(most_width_px) / canvas_.width_px(), double(most_height_px) / canvas_.height_px()});
  const int width_px = std::max(1, static_cast<int>(canvas_.width_px() * scale));
  const int height_px = std::max(1, static_cast<int>(canvas_.height_px() * scale));
  if (asked_target_.width_px() != width_px || asked_target_.height_px() != height_px) {
    auto target =
        gl::Target::Make({.width_px = width_px, .height_px = height_px, .texels = gl::Texels::kSrgb8});
    if (!target) return;
    asked_target_ = std::move(*target);
  }
  canvas_.ShrinkTo(asked_target_);
  readback_.Ask(asked_target_);
}

bool Studio::FetchPicture(SmallImage& into) {
  if (!readback_.pending()) return false;
  into.width_px = asked_target_.width_px();
  into.height_px = asked_target_.height_px();
  into.pixels.resize(std::size_t(into.width_px) * std::size_t(into.height_px) * 4);
  return readback_.Fetch(into.pixels);
}

// The vectors are as long as before, so that this allocates nothing.
void Studio::Renew(std::uint16_t index, std::span<const glm::vec3> displacement,
                   const std::array<float, 2>& lids) {
  face::Expression& expression = prepared_->show_.cast.expressions[index];
  expression.displacement.assign(displacement.begin(), displacement.end());
  expression.lids = lids;
  painter_->Renew(index);
}

}  // namespace kaori::stage
