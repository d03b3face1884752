#include "tests/benchmark/frame_benchmark.h"

#include <GLES3/gl3.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>

#include <fmt/format.h>

#include "appliance/core/show/pack.h"
#include "drivers/base/log.h"
#include "render/passes/painter.h"
#include "render/passes/quality.h"
#include "render/passes/screen.h"
#include "tests/benchmark/bare_draw.h"
#include "tests/benchmark/figures.h"
#include "tests/benchmark/lit_triangles.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::benchmark {
namespace {

struct Size {
  int width_px;
  int height_px;
};
constexpr Size kSizes[] = {{960, 540}, {1920, 1080}};
constexpr const char* kStyleNames[] = {"wire", "flat", "bare", "hair", "default"};

double CpuMs() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  const auto ms = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_usec) * 1e-3;
  };
  return ms(use.ru_utime) + ms(use.ru_stime);
}

double WallMs() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

// Logs why not.
template <class T>
bool Opened(const Result<T>& result) {
  if (!result) Log("no frames are measured: {}", result.error().message());
  return result.has_value();
}

using DrawOne = std::function<void(int frame)>;

struct Costs {
  std::vector<double> cpu_ms;
  std::vector<double> wall_ms;
};

// Frames until they are read back, so that all threads' work is in. The first ones warm up.
Costs Measure(const DrawOne& draw, int frames) {
  constexpr int kWarm = 3;
  Costs costs;
  for (int i = -kWarm; i < frames; ++i) {
    const double cpu = CpuMs();
    const double wall = WallMs();
    draw(i);
    if (i < 0) continue;
    costs.cpu_ms.push_back(CpuMs() - cpu);
    costs.wall_ms.push_back(WallMs() - wall);
  }
  return costs;
}

void Append(const std::string& name, const Costs& costs, std::vector<Metric>& metrics) {
  metrics.push_back(Figure(name + ".cpu_ms", "ms", costs.cpu_ms));
  metrics.push_back(Figure(name + ".wall_ms", "ms", costs.wall_ms));
}

// The head turns and blinks, so that no frame is like the last.
scene::Scene SceneAt(int frame, scene::Style style) {
  scene::Scene scene;
  const float beat = static_cast<float>(frame % 40) / 40;
  scene.weights.faces.Push(0, 1);
  scene.weights.expressions.Push(0, 1 - beat);
  scene.weights.expressions.Push(1, beat);
  scene.head.yaw_rad = 0.3F * (beat - 0.5F);
  scene.styles = {};
  scene.styles[static_cast<std::size_t>(style)] = 1;
  return scene;
}

// A canvas as the painter wants it, and the memory that its picture is read into.
struct Screen {
  Screen(Size size, const passes::Painter& painter)
      : canvas(*gl::Canvas::Make({.width_px = size.width_px,
                                  .height_px = size.height_px,
                                  .antialiasing = painter.antialiasing()})),
        bytes(static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px) * 4) {}
  gl::Canvas canvas;
  std::vector<std::uint8_t> bytes;
};

std::string NameOf(const char* what, Size size) {
  return fmt::format("frame.{}.{}x{}", what, size.width_px, size.height_px);
}

void MeasureStyles(passes::Painter& painter, Size size, int frames, std::vector<Metric>& metrics) {
  Screen screen(size, painter);
  for (int style = 0; style < scene::kStyleCount; ++style) {
    const auto draw = [&](int frame) {
      painter.Draw(SceneAt(frame, static_cast<scene::Style>(style)), screen.canvas);
      screen.canvas.ReadPixels(screen.bytes);
    };
    Append(NameOf(kStyleNames[style], size), Measure(draw, frames), metrics);
  }
}

// The default look as a graphics card draws it; nothing where a processor draws.
void MeasureFine(const gl::Context& context, passes::Painter& painter, int frames,
                 std::vector<Metric>& metrics) {
  if (passes::QualityFor(context.renderer()) == passes::Quality::kBasic) return;
  for (const auto& [quality, name] :
       {std::pair{passes::Quality::kFine, "fine"}, std::pair{passes::Quality::kFinest, "finest"}}) {
    if (!Opened(painter.SetQuality(quality))) return;
    for (const Size size : kSizes) {
      Screen screen(size, painter);
      const auto draw = [&](int frame) {
        painter.Draw(SceneAt(frame, scene::Style::kSoft), screen.canvas);
        screen.canvas.ReadPixels(screen.bytes);
      };
      Append(NameOf(name, size), Measure(draw, frames), metrics);
    }
  }
}

// Of the medians: one frame that a neighbour held up does not count.
double Over(const std::vector<double>& a_ms, const std::vector<double>& b_ms) {
  return Quantile(a_ms, 0.5) / std::max(Quantile(b_ms, 0.5), 1e-3);
}

// `ours` over `theirs`, round by round.
struct RoundRatios {
  std::vector<double> cpu;
  std::vector<double> wall;
};

// In turns, so that a busy neighbour hurts both.
RoundRatios InTurns(const DrawOne& ours, const DrawOne& theirs, int rounds) {
  constexpr int kFrames = 6;
  RoundRatios ratios;
  for (int round = -1; round < rounds; ++round) {
    const Costs a = Measure(ours, kFrames);
    const Costs b = Measure(theirs, kFrames);
    if (round < 0) continue;
    ratios.cpu.push_back(Over(a.cpu_ms, b.cpu_ms));
    ratios.wall.push_back(Over(a.wall_ms, b.wall_ms));
  }
  return ratios;
}

Metric Ratio(const char* name, const DrawOne& ours, const DrawOne& theirs, int rounds) {
  return Figure(name, "ratio", InTurns(ours, theirs, rounds).cpu);
}

Metric OverBareDraw(const face::Cast& cast, passes::Painter& painter, int rounds) {
  const Size size = kSizes[0];
  Screen screen(size, painter);
  BareDraw bare(cast, SceneAt(20, scene::Style::kSoft), screen.canvas);
  const DrawOne ours = [&](int frame) {
    painter.Draw(SceneAt(20 + (frame & 1), scene::Style::kSoft), screen.canvas);
    screen.canvas.ReadPixels(screen.bytes);
  };
  const DrawOne theirs = [&](int) { bare.Draw(screen.canvas, screen.bytes); };
  return Ratio("frame.default.over_bare_draw", ours, theirs, rounds);
}

// F2b: beside the least that draws as many triangles.
void MeasureOverLitTriangles(passes::Painter& painter, Size size, int rounds, std::vector<Metric>& metrics) {
  Screen screen(size, painter);
  LitTriangles lit(size.width_px, size.height_px);
  const DrawOne ours = [&](int frame) {
    painter.Draw(SceneAt(20 + (frame & 1), scene::Style::kSoft), screen.canvas);
    screen.canvas.ReadPixels(screen.bytes);
  };
  const DrawOne theirs = [&](int) { lit.Draw(screen.bytes); };
  Append(NameOf("lit_triangles", size), Measure(theirs, 6 * rounds), metrics);
  const RoundRatios ratios = InTurns(ours, theirs, rounds);
  metrics.push_back(Figure(NameOf("default_over_lit_triangles", size) + ".cpu", "ratio", ratios.cpu));
  metrics.push_back(Figure(NameOf("default_over_lit_triangles", size) + ".wall", "ratio", ratios.wall));
}

// The copy of a finished picture to a screen's window: all of it, and what of it has changed while the backdrop is
// at rest. What stands for the window is a target, as a software renderer has them both in memory.
void MeasureCopy(passes::Painter& painter, Size size, int frames, std::vector<Metric>& metrics) {
  auto pass = passes::ScreenPass::Open();
  auto window = gl::Target::Make({.width_px = size.width_px, .height_px = size.height_px});
  if (!Opened(pass) || !Opened(window)) return;
  Screen screen(size, painter);
  for (const bool whole : {true, false}) {
    Costs costs;
    for (int frame = -3; frame < frames; ++frame) {
      painter.Draw(SceneAt(frame + 3, scene::Style::kSoft), screen.canvas);
      screen.canvas.ReadPixels(screen.bytes);  // So that only the copy is counted.
      const double cpu = CpuMs();
      const double wall = WallMs();
      window->Begin();
      pass->Draw(screen.canvas, whole ? 0 : 1);
      glFinish();
      if (frame < 0) continue;
      costs.cpu_ms.push_back(CpuMs() - cpu);
      costs.wall_ms.push_back(WallMs() - wall);
    }
    Append(NameOf(whole ? "copy_whole" : "copy_changed", size), costs, metrics);
  }
}

struct SyntheticStage {
  SyntheticStage(const gl::Context& context, int faces, int expressions)
      : cast(tests::MakeSyntheticCast({.faces = faces, .expressions = expressions})) {
    cast.textures = {{.width_px = 1, .height_px = 1, .rgba = {200, 180, 170, 0}}};
    painter = std::move(*passes::Painter::Open(context, cast));
  }
  face::Cast cast;
  std::unique_ptr<passes::Painter> painter;
};

Metric Growth(const gl::Context& context, int rounds) {
  const SyntheticStage small(context, 10, 20);
  const SyntheticStage large(context, 100, 100);
  Screen screen(kSizes[0], *small.painter);
  const auto with = [&](const SyntheticStage& stage) {
    return [&](int frame) {
      stage.painter->Draw(SceneAt(frame, scene::Style::kSoft), screen.canvas);
      screen.canvas.ReadPixels(screen.bytes);
    };
  };
  return Ratio("frame.growth_100x100_over_10x20", with(large), with(small), rounds);
}

}  // namespace

std::vector<Metric> MeasureFrames(const std::string& pack, bool quick) {
  const auto show = show::LoadPack(pack);
  if (!Opened(show)) return {};
  const auto context = gl::Context::Open();
  if (!Opened(context)) return {};
  const auto painter = passes::Painter::Open(**context, show->cast);
  if (!Opened(painter)) return {};
  const int frames = quick ? 8 : 80;
  const int rounds = quick ? 3 : 15;
  std::vector<Metric> metrics;
  for (const Size size : kSizes) MeasureStyles(**painter, size, frames, metrics);
  for (const Size size : kSizes) MeasureOverLitTriangles(**painter, size, rounds, metrics);
  for (const Size size : kSizes) MeasureCopy(**painter, size, frames, metrics);
  metrics.push_back(OverBareDraw(show->cast, **painter, rounds));
  metrics.push_back(Growth(**context, rounds));
  MeasureFine(**context, **painter, frames, metrics);
  return metrics;
}

}  // namespace kaori::benchmark
