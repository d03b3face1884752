// kaori-benchmark: every figure of the box, as a table for people and as JSON for programs.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "appliance/core/show/pack.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/base/read_file.h"
#include "tests/benchmark/bars.h"
#include "tests/benchmark/blend_benchmark.h"
#include "tests/benchmark/frame_benchmark.h"
#include "tests/benchmark/hid_benchmark.h"
#include "tests/benchmark/lips_benchmark.h"
#include "tests/benchmark/pack_benchmark.h"
#include "tests/benchmark/sound_benchmark.h"
#include "tests/benchmark/system_benchmark.h"

namespace kaori::benchmark {
namespace {

constexpr std::string_view kHelp = R"(kaori-benchmark: measures the box

  --pack FILE   the show to play (needed)
  --quick       a tenth of the time
  --only TEXT   the groups whose names hold TEXT: blend, lips, sound, hid, frame, pack, system
  --json FILE   {"metrics": [{"name", "unit", "median", "p99"}]}
  --builds FILE what ./box bench --build measured: reported with the rest
Ends with 1 where a figure is above what is wanted of it on any machine, with a line for each.
)";

struct Settings {
  std::string pack, json, only, builds;
  bool quick = false;
};

struct Group {
  const char* name;
  std::function<std::vector<Metric>(const Settings&)> measure;
};

const std::vector<Group>& Groups() {
  static const std::vector<Group> groups{
      {"blend", [](const Settings& o) { return MeasureBlend(o.quick); }},
      {"lips", [](const Settings& o) { return MeasureLips(o.quick); }},
      {"lips motion", [](const Settings& o) { return MeasureLipMotion(o.quick); }},
      {"sound", [](const Settings& o) { return MeasureSound(o.pack, o.quick); }},
      {"hid", [](const Settings& o) { return MeasureHid(o.quick); }},
      {"frame", [](const Settings& o) { return MeasureFrames(o.pack, o.quick); }},
      {"pack", [](const Settings& o) { return MeasurePacks(o.pack, o.quick); }},
      {"system", [](const Settings& o) { return MeasureSystem(o.pack, o.quick); }}};
  return groups;
}

void Print(const Metric& m) {
  const Bar* const bar = BarOf(m.name, Bars());
  const std::string wanted = bar == nullptr ? "" : fmt::format("; at most {:.4g} is wanted", bar->most);
  fmt::print("{:<44} {:>12.4g} {:>12.4g}  {}{}\n", m.name, m.median, m.p99, m.unit, wanted);
}

// The bars of all that is measured by these settings: with --only no figure is missed.
std::vector<Bar> BarsToReach(const Settings& settings, const std::vector<Metric>& measured) {
  std::vector<Bar> bars;
  for (const Bar& bar : Bars()) {
    const bool is_asked_for =
        bar.name.starts_with("build.") ? !settings.builds.empty() : settings.only.empty();
    if (is_asked_for || std::ranges::find(measured, bar.name, &Metric::name) != measured.end())
      bars.push_back(bar);
  }
  return bars;
}

// The last lines for people: a figure that is too high is easily passed over among so many. Whether none is.
bool PrintMissedBars(const Settings& settings, const std::vector<Metric>& all) {
  const Comparison compared = CompareWithBars(all, BarsToReach(settings, all));
  for (const auto& lines : {compared.missing, compared.above})
    for (const std::string& line : lines) fmt::print("{}\n", line);
  return compared.above.empty();
}

// What builds cost, as `./box bench --build` wrote it. Errors: those of ReadFile; invalid_argument where a figure is missing.
Result<std::vector<Metric>> ReadBuildCosts(const std::string& file) {
  const auto text = ReadFile(file, {.most_levels = kMostLevels});
  if (!text) return tl::unexpected(text.error());
  const auto costs = nlohmann::json::parse(*text, nullptr, false);
  std::vector<Metric> metrics;
  for (const auto& [figure, unit] : {std::pair{"demo_cpu_s", "s of CPU"}, std::pair{"test_cpu_s", "s of CPU"},
                                     std::pair{"kernel_cpu_s", "s of CPU"}, std::pair{"touched_s", "s"}}) {
    const auto cost = costs.is_object() ? costs.find(fmt::format("build_{}", figure)) : costs.end();
    if (cost == costs.end() || !cost->is_number())
      return FailInput(fmt::format("{} does not say build_{}", file, figure));
    metrics.push_back({fmt::format("build.{}", figure), unit, *cost, *cost});
  }
  return metrics;
}

bool WriteJson(const std::string& file, const std::vector<Metric>& metrics) {
  nlohmann::json list = nlohmann::json::array();
  for (const Metric& m : metrics)
    list.push_back({{"name", m.name}, {"unit", m.unit}, {"median", m.median}, {"p99", m.p99}});
  std::ofstream out(file);
  out << nlohmann::json{{"metrics", list}}.dump(1) << '\n';
  return static_cast<bool>(out.flush());
}

// Files that people named are looked at before anything is measured, which takes minutes.
int Run(const Settings& settings) {
  std::vector<Metric> all;
  if (const auto show = show::LoadPack(settings.pack); !show) return ExitWithError(show.error());
  if (!settings.builds.empty()) {
    auto costs = ReadBuildCosts(settings.builds);
    if (!costs) return ExitWithError(costs.error());
    all = std::move(*costs);
  }
  fmt::print("{:<44} {:>12} {:>12}  unit\n", "figure", "median", "p99");
  for (const Metric& metric : all) Print(metric);
  for (const Group& group : Groups()) {
    if (std::string_view(group.name).find(settings.only) == std::string_view::npos) continue;
    for (const Metric& metric : group.measure(settings)) {
      Print(metric);
      all.push_back(metric);
    }
    std::fflush(stdout);
  }
  const bool all_reached = PrintMissedBars(settings, all);
  if (settings.json.empty() || WriteJson(settings.json, all)) return all_reached ? 0 : 1;
  fmt::print(stderr, "kaori-benchmark: cannot write {}\n", settings.json);
  return 1;
}

int Main(int argc, char** argv) {
  Settings settings;
  Options options(kHelp);
  options.Text("--pack", settings.pack, true).Text("--json", settings.json).Text("--only", settings.only);
  options.Text("--builds", settings.builds);
  options.Switch("--quick", settings.quick);
  if (const auto status = options.Parse(argc, argv)) return *status;
  return Run(settings);
}

}  // namespace
}  // namespace kaori::benchmark

int main(int argc, char** argv) {
  return kaori::benchmark::Main(argc, argv);
}
