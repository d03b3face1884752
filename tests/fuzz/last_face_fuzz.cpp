// What the first program reads before anything else runs: the last face, as the stage left it or as a disk
// has spoilt it, and the settings. Some inputs get a right end, or nothing would come past it.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include "appliance/core/last_face/last_face.h"
#include "appliance/programs/boot/profile.h"
#include "appliance/programs/boot/still.h"
#include "tests/fuzz/check.h"

namespace {

using kaori::boot::Still;

void Lay(const Still& still) {
  constexpr int kWidth_px = 7, kHeight_px = 5;
  std::vector<std::uint8_t> memory(std::size_t{kWidth_px} * kHeight_px * 4);
  kaori::boot::LayStill(still, {memory.data(), kWidth_px, kHeight_px, std::size_t{kWidth_px} * 4});
}

void ReadWhole(std::span<const std::uint8_t> body, std::size_t picture) {
  const kaori::last_face::Content face{
      .show = 0, .picture = body.first(picture), .state = body.subspan(picture)};
  const auto end = kaori::last_face::EndOf(face);
  std::vector<std::uint8_t> file(body.begin(), body.end());
  std::copy(end.begin(), end.end(), std::back_inserter(file));
  const auto read = kaori::last_face::Read(file);
  kaori::fuzz::Promise(read && read->picture.size() == picture && read->state.size() == body.size() - picture,
                       "what was written can be read");
  if (const auto still = kaori::boot::ReadStill(read->picture)) Lay(*still);
}

void ParseSettings(std::string_view text) {
  const auto profile = kaori::boot::ReadProfile(text);
  kaori::fuzz::Promise(kaori::boot::CheckWiring(profile.wiring).empty(), "no line is two things");
  kaori::fuzz::Promise(std::ranges::count(kaori::boot::EnvironmentOf(profile.wiring), '\n') == 2,
                       "the lines are two lines for systemd");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  if (const auto still = kaori::boot::ReadLastStill(bytes, {})) Lay(*still);
  if (size > 0) ReadWhole(bytes.subspan(1), std::min<std::size_t>(size - 1, std::size_t{data[0]} * 4));
  ParseSettings({reinterpret_cast<const char*>(data), size});
  return 0;
}
