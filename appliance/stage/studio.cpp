#include "appliance/stage/studio.h"

namespace kaori::stage {

Result<std::unique_ptr<Studio>> Studio::Open(show::Show show) {
  auto context = gl::Context::Open();
  if (!context) return tl::unexpected(context.error());
  std::unique_ptr<Studio> studio(new Studio(std::move(*context), std::move(show)));
  auto painter = passes::Painter::Open(*studio->context_, studio->show_.cast);
  if (!painter) return tl::unexpected(painter.error());
  studio->painter_ = std::move(*painter);
  return studio;
}

Result<void> Studio::Draw(const scene::Scene& scene, const ports::PixelBuffer& picture) {
  if (canvas_.width_px() != picture.width_px || canvas_.height_px() != picture.height_px) {
    auto canvas = gl::Canvas::Make({.width_px = picture.width_px, .height_px = picture.height_px});
    if (!canvas) return tl::unexpected(canvas.error());
    canvas_ = std::move(*canvas);
  }
  painter_->Draw(scene, canvas_);
  canvas_.ReadPixels(picture.bytes);
  return {};
}

}  // namespace kaori::stage
