#include "tests/benchmark/bare_draw.h"

#include <cstdlib>

#include "drivers/base/log.h"

namespace kaori::benchmark {
namespace {

template <class T>
T Must(Result<T> made) {
  if (made) return std::move(*made);
  Log("{}", made.error().message());
  std::abort();
}

}  // namespace

BareDraw::BareDraw(const face::Cast& cast, const scene::Scene& scene, const gl::Canvas& canvas)
    : composer_(cast),
      shape_(composer_.Compose(scene.weights, face::Detail::kFine)),
      scene_(scene),
      appearance_(cast, passes::FormsOf(cast.props)),
      surface_(cast, passes::SeenWhenWorn(cast)),
      body_(Must(passes::BodyPass::Open(cast, passes::Quality::kBasic))),
      eyes_(Must(passes::EyesPass::Open(cast.topology))),
      hair_(Must(passes::HairPass::Open(passes::Quality::kBasic))),
      clothes_(Must(passes::ClothesPass::Open())),
      dressing_(passes::Necks(cast).Dress(shape_.faces)),
      backdrop_(Must(passes::BackdropPass::Open(cast))),
      layer_(Must(passes::LayerPass::Open())),
      frame_(gl::BufferUse::kStatic, sizeof(passes::FrameBlock)) {
  surface_.WriteFine(shape_);
  appearance_.Weigh(shape_.faces);
  hairdo_.Comb(appearance_, passes::HeadFit(cast), shape_.faces, 1);
  block_ = passes::MakeFrame(scene, passes::NeckOf(cast), canvas, 1);
  frame_.Write(std::as_bytes(std::span(&block_, 1)));
  figure_ = passes::FindFigure(block_, {canvas.width_px(), canvas.height_px()}, shape_, appearance_,
                               passes::MeasureEdges(cast));
}

void BareDraw::Draw(const gl::Canvas& canvas, std::span<std::uint8_t> bytes) {
  frame_.BindUniforms(passes::kFrameBinding);
  backdrop_.Prepare(scene_, canvas.width_px(), canvas.height_px());
  const passes::LayerPass::Behind behind{backdrop_.picture(), backdrop_.version()};
  layer_.LayBackdropAround(canvas, figure_, behind);
  canvas.BeginLayer(figure_.bands, figure_.whole);
  hair_.Draw(appearance_, hairdo_, block_, nullptr);
  clothes_.Draw(appearance_, dressing_, block_);
  body_.Draw(surface_, shape_, true, nullptr);
  hair_.DrawBehind(appearance_, hairdo_, block_, nullptr);
  eyes_.Draw(shape_, scene_.gaze, scene_.pupil);
  layer_.Lay(canvas, figure_, behind, {});
  canvas.ReadPixels(bytes);
}

}  // namespace kaori::benchmark
