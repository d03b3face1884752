#include "tests/benchmark/hid_benchmark.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "appliance/programs/input/dial_slot.h"
#include "appliance/programs/input/learnt_turns.h"
#include "appliance/programs/input/surface_section.h"
#include "drivers/base/clock.h"
#include "firmware/wire/dial_box.h"

namespace kaori::benchmark {
namespace {

constexpr int kHidRounds = 50;
constexpr int kReportsARound = 20'000;

ports::HidIdentity DialBox() {
  return {.port = "benchmark",
          .vendor = wire::kDialBoxVendor,
          .product = wire::kDialBoxProduct,
          .name = "dial box",
          .descriptor = {wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end()}};
}

double ReportsPerSecond(input::DialSlot& dial_box, const Clock& clock) {
  wire::DialBoxReport report{.turned = {1, -1, 2, -2, 3, -3, 4, -4}};
  const Time begin = clock.now();
  for (int i = 0; i < kReportsARound; ++i) {
    report.buttons_down = static_cast<std::uint32_t>(i);
    if (!dial_box.Accept(wire::Encode(report), begin)) return 0;
    dial_box.Publish();
  }
  return kReportsARound / Seconds(clock.now() - begin);
}

}  // namespace

std::vector<Metric> MeasureHid(bool quick) {
  const auto path =
      std::filesystem::temp_directory_path() / fmt::format("kaori-benchmark-board-{}", ::getpid());
  const auto board = board::Board::Create(path.string());
  if (!board) return {};
  auto writer = board->AcquireWriter<board::Surface>();
  std::filesystem::remove(path);
  if (!writer) return {};
  const SteadyClock clock;
  input::SurfaceSection section(*board, std::move(*writer), wire::kDialCountsPerTurn, 1);
  const std::vector<input::SurfaceMap> no_maps;
  const input::LearntTurns nothing_learnt({});
  input::DialSlot dial_box(*board, section, 0, no_maps, nothing_learnt);
  if (!dial_box.Plug(DialBox(), clock.now())) return {};
  std::vector<double> rates;
  for (int i = 0; i < kHidRounds / (quick ? 10 : 1); ++i) rates.push_back(ReportsPerSecond(dial_box, clock));
  std::ranges::sort(rates);
  // Of a rate the slow end is the one that matters: "p99" is what 99 of 100 rounds reached.
  return {{"hid.reports_per_s", "1/s", rates[rates.size() / 2], rates.front()}};
}

}  // namespace kaori::benchmark
