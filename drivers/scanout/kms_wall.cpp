#include "drivers/scanout/kms_wall.h"

#include <algorithm>
#include <numeric>

namespace kaori::scanout {
namespace {

// The least number of columns that is no smaller than that of rows and leaves no cell empty.
std::size_t ColumnsOf(std::size_t screens) {
  std::size_t columns = 1;
  while (columns < screens && (columns * columns < screens || screens % columns != 0)) ++columns;
  return columns;
}

}  // namespace

// Screens of different sizes keep their own pixels: a smaller one shows the upper left part of its cell.
KmsWall Arrange(std::vector<KmsOutput> outputs) {
  const std::size_t columns = ColumnsOf(outputs.size());
  std::vector<int> widths_px(columns, 0);
  std::vector<int> heights_px((outputs.size() + columns - 1) / columns, 0);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto& mode = outputs[i].chosen.mode;
    widths_px[i % columns] = std::max<int>(widths_px[i % columns], mode.hdisplay);
    heights_px[i / columns] = std::max<int>(heights_px[i / columns], mode.vdisplay);
  }
  // Where a column or a row begins: behind the widest or highest screens before it. With
  // `count` of all it is the sum of the whole.
  const auto sum = [](const std::vector<int>& lengths_px, std::size_t count) {
    return std::accumulate(lengths_px.begin(), lengths_px.begin() + std::ptrdiff_t(count), 0);
  };
  KmsWall wall{{}, sum(widths_px, widths_px.size()), sum(heights_px, heights_px.size())};
  for (std::size_t i = 0; i < outputs.size(); ++i)
    wall.panels.push_back({std::move(outputs[i]), sum(widths_px, i % columns), sum(heights_px, i / columns)});
  return wall;
}

const KmsOutput& Largest(const KmsWall& wall) {
  const auto area = [](const KmsPanel& panel) {
    return int{panel.output.chosen.mode.hdisplay} * panel.output.chosen.mode.vdisplay;
  };
  return std::ranges::max_element(wall.panels, {}, area)->output;
}

std::string Describe(const KmsWall& wall) {
  std::string text;
  for (const KmsPanel& panel : wall.panels)
    text += (text.empty() ? "" : "; ") +
            ports::Describe(PortOutput(panel.output, ports::OutputState::kShowsPicture));
  if (wall.status) text += "; " + ports::Describe(PortOutput(*wall.status, ports::OutputState::kShowsStatus));
  if (wall.monitor)
    text += "; " + ports::Describe(PortOutput(*wall.monitor, ports::OutputState::kShowsMonitor));
  return text;
}

}  // namespace kaori::scanout
