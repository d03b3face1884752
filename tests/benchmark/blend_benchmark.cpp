#include "tests/benchmark/blend_benchmark.h"

#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <string>

#include <fmt/format.h>

#include "render/face/aligned.h"
#include "render/face/blend.h"
#include "render/face/composer.h"
#include "tests/benchmark/bare_loop.h"
#include "tests/benchmark/figures.h"
#include "tests/benchmark/rounds.h"
#include "tests/benchmark/textbook_blend.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::benchmark {
namespace {

constexpr std::size_t kShapes = 4;

// Four shapes of so many vertices, in both layouts, and memory for the result.
struct FourShapes {
  explicit FourShapes(std::size_t vertices);

  std::vector<face::AlignedFloats> aligned;
  std::vector<face::Stream> streams;
  Shapes textbook;
  std::array<float, kShapes> weights{0.4F, 0.3F, 0.2F, 0.1F};
  std::size_t floats;
  face::AlignedFloats out;  // Of both: arrays that lie elsewhere may share cache sets with their sources.
  std::vector<glm::vec3> textbook_out;
};

FourShapes::FourShapes(std::size_t vertices)
    : floats(face::Padded(3 * vertices)), out(floats), textbook_out(vertices) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> value(-0.1F, 0.1F);
  for (std::size_t k = 0; k < kShapes; ++k) {
    aligned.emplace_back(floats);
    for (std::size_t i = 0; i < 3 * vertices; ++i) aligned.back().data()[i] = value(random);
    const auto shape = aligned.back().vertices(vertices);
    textbook.emplace_back(shape.begin(), shape.end());
    streams.push_back({aligned.back().data(), weights[k]});
  }
}

// Keeps the compiler from leaving work out whose result nobody reads.
void Use(const void* result) {
  asm volatile("" : : "r"(result) : "memory");
}

struct BlendTimes {
  std::vector<double> us;
  std::vector<double> over_bare_loop;
  std::vector<double> over_textbook;
};

BlendTimes TimeBlend(std::size_t vertices, bool quick) {
  FourShapes shapes(vertices);
  Arm ours{[&] {
             face::Blend(shapes.streams, shapes.floats, shapes.out.data());
             Use(shapes.out.data());
           },
           {}};
  std::array<const float*, kShapes> values{};
  std::ranges::transform(shapes.aligned, values.begin(), [](const auto& shape) { return shape.data(); });
  Arm bare{[&] {
             BareLoop(values, shapes.weights, shapes.floats, shapes.out.data());
             Use(shapes.out.data());
           },
           {}};
  const std::vector<float> weights(shapes.weights.begin(), shapes.weights.end());
  Arm textbook{[&] {
                 TextbookBlend(shapes.textbook, weights, shapes.textbook_out);
                 Use(shapes.textbook_out.data());
               },
               {}};
  const int calls = static_cast<int>(2'000'000 / vertices);
  RunInTurns({&ours, &bare, &textbook}, quick ? 9 : 45, calls);
  return {ours.us, Ratios(ours.us, bare.us), Ratios(textbook.us, ours.us)};
}

face::Weights MiddleOfTwoFades() {
  face::Weights w;
  w.faces.Push(0, 0.5F);
  w.faces.Push(1, 0.5F);
  w.expressions.Push(1, 0.5F);
  w.expressions.Push(2, 0.5F);
  w.channels.Push(4, 0.3F);
  return w;
}

// One head of the default cast's size (about 2700 vertices), and a composer for it.
struct Stage {
  Stage(int faces, int expressions)
      : cast(tests::MakeSyntheticCast(
            {.columns = 64, .rows = 40, .faces = faces, .expressions = expressions})),
        composer(cast) {}
  face::Cast cast;
  face::Composer composer;
};

Arm ComposeArm(Stage& stage, face::Detail detail) {
  return {[&stage, detail, weights = MiddleOfTwoFades()] { Use(&stage.composer.Compose(weights, detail)); },
          {}};
}

void MeasureCompose(bool quick, std::vector<Metric>& metrics) {
  Stage small(10, 20);
  Stage large(100, 100);
  Arm cage = ComposeArm(small, face::Detail::kCage);
  Arm fine = ComposeArm(small, face::Detail::kFine);
  Arm fine_of_large = ComposeArm(large, face::Detail::kFine);
  RunInTurns({&cage, &fine, &fine_of_large}, quick ? 9 : 45, 100);
  metrics.push_back(Figure("compose.cage_us", "us", cage.us));
  metrics.push_back(Figure("compose.fine_us", "us", fine.us));
  metrics.push_back(Figure("compose.growth_100x100_over_10x20", "ratio", Ratios(fine_of_large.us, fine.us)));
}

}  // namespace

std::vector<Metric> MeasureBlend(bool quick) {
  const BlendTimes small = TimeBlend(2300, quick);
  const BlendTimes face = TimeBlend(2800, quick);
  const BlendTimes large = TimeBlend(25'000, quick);
  const auto worse = [](const Metric& a, const Metric& b, bool higher_is_worse) {
    return (a.median > b.median) == higher_is_worse ? a : b;
  };
  std::vector<Metric> metrics;
  metrics.push_back(worse(Figure("blend.over_bare_loop", "ratio", small.over_bare_loop),
                          Figure("blend.over_bare_loop", "ratio", large.over_bare_loop), true));
  metrics.push_back(worse(Figure("blend.over_textbook", "ratio", small.over_textbook),
                          Figure("blend.over_textbook", "ratio", large.over_textbook), false));
  metrics.push_back(Figure("blend.2800.us", "us", face.us));
  metrics.push_back(Figure("blend.25000.us", "us", large.us));
  MeasureCompose(quick, metrics);
  return metrics;
}

}  // namespace kaori::benchmark
