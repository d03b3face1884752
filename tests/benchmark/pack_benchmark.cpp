#include "tests/benchmark/pack_benchmark.h"

#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <utility>

#include "appliance/core/show/pack.h"
#include "appliance/programs/stage/studio.h"
#include "drivers/base/log.h"
#include "render/face/composites.h"
#include "tests/appliance/core/large_show.h"
#include "tests/benchmark/figures.h"

namespace kaori::benchmark {
namespace {

double NowMs(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double RssMb() {
  std::ifstream in("/proc/self/statm");
  std::size_t pages = 0;
  in >> pages >> pages;
  return static_cast<double>(pages) * static_cast<double>(::sysconf(_SC_PAGESIZE)) * 1e-6;
}

struct Times {
  std::vector<double> wall_ms;
  std::vector<double> cpu_ms;

  void Measure(const std::function<void()>& once) {
    const double wall = NowMs(CLOCK_MONOTONIC);
    const double cpu = NowMs(CLOCK_PROCESS_CPUTIME_ID);
    once();
    cpu_ms.push_back(NowMs(CLOCK_PROCESS_CPUTIME_ID) - cpu);
    wall_ms.push_back(NowMs(CLOCK_MONOTONIC) - wall);
  }
};

// A show that was loaded, or none and a line in the log.
std::optional<show::Show> Load(const std::filesystem::path& file) {
  auto show = show::LoadPack(file);
  if (show) return std::move(*show);
  Log("no packs are measured: {}", show.error().message());
  return std::nullopt;
}

Times TimeLoads(const std::filesystem::path& file, int rounds) {
  Times times;
  for (int i = 0; i < rounds; ++i) times.Measure([&] { (void)Load(file); });
  return times;
}

std::unique_ptr<stage::Studio> OpenStudio(show::Show show, Times& times) {
  std::unique_ptr<stage::Studio> studio;
  times.Measure([&] {
    auto opened = stage::Studio::Open(std::move(show));
    if (opened) studio = std::move(*opened);
  });
  return studio;
}

void MeasureDefault(const std::string& pack, int rounds, std::vector<Metric>& metrics) {
  const auto show = Load(pack);
  if (!show) return;
  const Times loads = TimeLoads(pack, rounds);
  metrics.push_back(Figure("pack.load_ms", "ms", loads.wall_ms));
  metrics.push_back(Figure("pack.load.cpu_ms", "ms", loads.cpu_ms));
  Times compositions;
  for (int i = 0; i < rounds; ++i) compositions.Measure([&] { const face::Composites all(show->cast); });
  metrics.push_back(Figure("pack.compose_ms", "ms", compositions.wall_ms));
  Times openings;
  for (int i = 0; i < rounds / 3 + 1; ++i) OpenStudio(*show, openings);
  metrics.push_back(Figure("pack.open_ms", "ms", openings.wall_ms));
}

Times TimeFrames(stage::Studio& studio, int frames) {
  Times times;
  std::vector<std::uint8_t> bytes(std::size_t{960} * 540 * 4);
  for (int frame = 0; frame < frames; ++frame) {
    scene::Scene scene;
    scene.weights.faces.Push(static_cast<std::uint16_t>(frame % 16), 1);
    scene.weights.expressions.Push(static_cast<std::uint16_t>(frame % 40), 1);
    times.Measure([&] { (void)studio.Draw(scene, {960, 540, ports::PixelMemory{bytes}}); });
  }
  return times;
}

void MeasureLarge(const std::filesystem::path& file, int rounds, std::vector<Metric>& metrics) {
  if (!show::SavePack(tests::MakeLargeShow(), file)) return;
  metrics.push_back(Figure("pack.large.load_ms", "ms", TimeLoads(file, rounds).wall_ms));
  const double before_mb = RssMb();
  auto show = Load(file);
  if (!show) return;
  Times openings;
  const auto studio = OpenStudio(std::move(*show), openings);
  if (studio == nullptr) return;
  metrics.push_back(Figure("pack.large.open_ms", "ms", openings.wall_ms));
  metrics.push_back(Figure("pack.large.frame_ms", "ms", TimeFrames(*studio, 10).wall_ms));
  metrics.push_back(Figure("pack.large.rss_mb", "MB", {RssMb() - before_mb}));
}

}  // namespace

std::vector<Metric> MeasurePacks(const std::string& pack, bool quick) {
  std::vector<Metric> metrics;
  const int rounds = quick ? 3 : 15;
  MeasureDefault(pack, rounds, metrics);
  const auto file = std::filesystem::temp_directory_path() / fmt::format("kaori-large-{}.kaori", ::getpid());
  MeasureLarge(file, rounds, metrics);
  std::error_code error;
  std::filesystem::remove(file, error);
  return metrics;
}

}  // namespace kaori::benchmark
