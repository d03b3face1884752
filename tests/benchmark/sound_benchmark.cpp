#include "tests/benchmark/sound_benchmark.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "appliance/core/show/pack.h"
#include "tests/appliance/programs/voice_claps.h"
#include "tests/benchmark/figures.h"

namespace kaori::benchmark {

std::vector<Metric> MeasureSound(const std::string& pack, bool quick) {
  auto show = show::LoadPack(pack);
  if (!show) throw std::runtime_error(show.error().message());
  const auto studio = stage::Studio::Open(std::move(*show));
  if (!studio) throw std::runtime_error(studio.error().message());
  const std::string folder =
      std::filesystem::temp_directory_path() / fmt::format("kaori-sound-benchmark-{}", ::getpid());
  const auto report = tests::ClapIn(folder, **studio, {.claps = quick ? 5 : 25});
  std::filesystem::remove_all(folder);
  if (!report) throw std::runtime_error(report.error().message());
  std::vector<double> apart_ms;
  for (const tests::Clap& clap : report->claps) apart_ms.push_back(std::abs(clap.apart_ms()));
  return {Figure("lips.sound_minus_picture_ms", "ms", apart_ms)};
}

}  // namespace kaori::benchmark
