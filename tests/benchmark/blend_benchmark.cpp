#include "tests/benchmark/blend_benchmark.h"

#include <cstring>
#include <memory>
#include <random>
#include <string>

#include <fmt/format.h>

#include "render/face/aligned.h"
#include "render/face/blend.h"
#include "render/face/composer.h"
#include "tests/benchmark/rounds.h"
#include "tests/benchmark/textbook_blend.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::benchmark {
namespace {

constexpr std::size_t kShapes = 4;

// Four shapes of so many vertices, in both layouts, with room for the result.
struct FourShapes {
  explicit FourShapes(std::size_t vertices);

  std::vector<face::AlignedFloats> aligned;
  std::vector<face::Stream> streams;
  Shapes textbook;
  std::vector<float> weights{0.4F, 0.3F, 0.2F, 0.1F};
  std::size_t floats;
  face::AlignedFloats out;
  face::AlignedFloats copy;
  std::vector<glm::vec3> textbook_out;
};

FourShapes::FourShapes(std::size_t vertices)
    : floats(face::Padded(3 * vertices)), out(floats), copy(floats), textbook_out(vertices) {
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
  std::vector<double> over_memcpy;
  std::vector<double> over_textbook;
};

BlendTimes TimeBlend(std::size_t vertices, bool quick) {
  FourShapes shapes(vertices);
  Arm ours{[&] {
             face::Blend(shapes.streams, shapes.floats, shapes.out.data());
             Use(shapes.out.data());
           },
           {}};
  Arm copy{[&] {
             std::memcpy(shapes.copy.data(), shapes.aligned[0].data(), shapes.floats * sizeof(float));
             Use(shapes.copy.data());
           },
           {}};
  Arm textbook{[&] {
                 TextbookBlend(shapes.textbook, shapes.weights, shapes.textbook_out);
                 Use(shapes.textbook_out.data());
               },
               {}};
  const int calls = static_cast<int>(2'000'000 / vertices);
  RunInTurns({&ours, &copy, &textbook}, quick ? 9 : 45, calls);
  return {ours.us, Ratios(ours.us, copy.us), Ratios(textbook.us, ours.us)};
}

Metric Summary(std::string name, std::string unit, const std::vector<double>& values) {
  return {std::move(name), std::move(unit), Quantile(values, 0.5), Quantile(values, 0.99)};
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
      : cast(testing::MakeSyntheticCast(
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
  metrics.push_back(Summary("compose.cage_us", "us", cage.us));
  metrics.push_back(Summary("compose.fine_us", "us", fine.us));
  metrics.push_back(Summary("compose.growth_100x100_over_10x20", "ratio", Ratios(fine_of_large.us, fine.us)));
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
  metrics.push_back(worse(Summary("blend.over_memcpy", "ratio", small.over_memcpy),
                          Summary("blend.over_memcpy", "ratio", large.over_memcpy), true));
  metrics.push_back(worse(Summary("blend.over_textbook", "ratio", small.over_textbook),
                          Summary("blend.over_textbook", "ratio", large.over_textbook), false));
  metrics.push_back(Summary("blend.2800.us", "us", face.us));
  metrics.push_back(Summary("blend.25000.us", "us", large.us));
  MeasureCompose(quick, metrics);
  return metrics;
}

}  // namespace kaori::benchmark
