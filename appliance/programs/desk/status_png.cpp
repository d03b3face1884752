#include "appliance/programs/desk/status_png.h"

#include <filesystem>

#include "appliance/programs/status/facts.h"
#include "appliance/programs/status/lines.h"
#include "appliance/programs/status/sheet.h"
#include "render/image/png.h"

namespace kaori::desk {
namespace {

// The size at which the page shows it.
constexpr int kWidth_px = 960, kHeight_px = 540;

}  // namespace

Result<std::string> StatusPng(const board::Board& board, Time now) {
  const auto facts =
      status::ReadFacts({.screens = std::filesystem::path(board.path()).parent_path() / "screens"});
  const auto picture =
      status::DrawAll(status::Describe(status::Look(board, facts, now)), kWidth_px, kHeight_px);
  if (!picture) return tl::unexpected(picture.error());
  return image::EncodePng(*picture).map(
      [](const auto& bytes) { return std::string(bytes.begin(), bytes.end()); });
}

}  // namespace kaori::desk
