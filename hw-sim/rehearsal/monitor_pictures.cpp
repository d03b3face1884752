#include "hw-sim/rehearsal/monitor_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>

namespace kaori::sim {

std::time_t EveningBegins() {
  std::tm evening{};
  evening.tm_year = 126;  // Since 1900.
  evening.tm_mday = 20;
  evening.tm_hour = 19;
  evening.tm_min = 30;
  evening.tm_isdst = -1;
  return ::mktime(&evening);
}

Result<void> PictureDisplay::Show(std::span<const std::uint8_t> rgbx,
                                  std::span<const ports::DisplayArea> areas) {
  if (rgbx.size() != picture_.rgbx.size()) return FailInput("show a picture of another size");
  for (const ports::DisplayArea& area : areas)
    for (int row = area.bottom_px; row < area.top_px; ++row) {
      const auto at = [&](int column) {
        return (static_cast<std::ptrdiff_t>(row) * picture_.width_px + column) * 4;
      };
      std::copy(rgbx.begin() + at(area.left_px), rgbx.begin() + at(area.right_px),
                picture_.rgbx.begin() + at(area.left_px));
    }
  ++shows_;
  return {};
}

Result<MonitorPictures> MonitorPictures::Open(const std::string& folder, Size size, int hz) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + folder);
  return MonitorPictures(folder, size, hz);
}

Result<void> MonitorPictures::Write() {
  const int number = pictures_++;
  if (number % hz_ != 0) return {};
  return image::WritePng(fmt::format("{}/{:04}.png", folder_, number / hz_), display_.picture());
}

}  // namespace kaori::sim
