// A fixture: the input service with a Stream Deck's twin, two calls on the board, and a folder with their pictures.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "drivers/web/jpeg.h"
#include "firmware/wire/bytes.h"
#include "hw-sim/devices/stream_deck.h"
#include "tests/appliance/programs/input_owned_fixture.h"

namespace kaori::input {

inline constexpr std::uint64_t kSmile = 0x0123456789ABCDEF, kDog = 0xFEDCBA9876543210;

inline int LinesIn(const std::string& text) {
  return static_cast<int>(std::ranges::count(text, '\n'));
}

// A key of one grey, as a file for decks that take JPEG, or for a Mini.
inline std::string GreyJpeg(int side_px, std::uint8_t grey) {
  const std::vector<std::uint8_t> rgbx(static_cast<std::size_t>(side_px * side_px * 4), grey);
  return web::JpegEncoder().Encode({.width_px = side_px, .height_px = side_px, .rgbx = rgbx}, 90).value();
}
inline std::string GreyBitmap(std::uint8_t grey) {
  constexpr std::size_t kBytes = 54 + 80 * 80 * 3;
  std::vector<std::uint8_t> file(kBytes, grey);
  std::fill_n(file.begin(), 54, std::uint8_t{0});
  file[0] = 'B', file[1] = 'M';
  for (const auto& [at, value] :
       {std::pair<std::size_t, std::uint32_t>{2, kBytes}, {10, 54}, {14, 40}, {18, 80}, {22, 80}})
    wire::PutU32(file, at, value);
  file[26] = 1, file[28] = 24;
  return {file.begin(), file.end()};
}

class Decks : public OwnedDevices {
 protected:
  Decks() {
    std::filesystem::create_directories(pictures());
    for (SurfaceMap& map : maps_)
      if (!map.pictures.empty()) map.pictures = pictures();
    for (const auto& [sum, grey] : {std::pair{kSmile, std::uint8_t{60}}, {kDog, std::uint8_t{90}}})
      for (const bool is_lit : {false, true}) {
        const auto level = static_cast<std::uint8_t>(is_lit ? grey + 120 : grey);
        Put(fmt::format("72/{:016x}{}.jpg", sum, is_lit ? "-lit" : ""), GreyJpeg(72, level));
        Put(fmt::format("80/{:016x}{}.bmp", sum, is_lit ? "-lit" : ""), GreyBitmap(level));
      }
    Put("72/blank.jpg", GreyJpeg(72, 0));
    board::ButtonCalls calls;
    calls.sums[0][2] = kSmile;
    calls.sums[1][2] = kDog;
    calls_.Write(calls, clock_.now(), board::SourceState::kLive);
  }
  std::filesystem::path pictures() const { return file_.folder() / "pictures"; }
  void Put(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((pictures() / name).parent_path());
    std::ofstream(pictures() / name, std::ios::binary) << bytes;
  }
  void Light(std::uint32_t lamps) { lamps_.Write({.lit = lamps}, clock_.now(), board::SourceState::kLive); }
  void PlugAndPlay(sim::StreamDeck& deck) {
    PlugIn("deck", deck);
    RecordProperty("twin", deck.device_name().name);
    Start();
    Play(std::chrono::milliseconds(400));
    ASSERT_EQ(service_->attached_devices(), 1);
  }
  static void ExpectGrey(const sim::StreamDeck& deck, int key, double grey) {
    ASSERT_TRUE(deck.picture(key)) << "key " << key << " shows nothing";
    EXPECT_NEAR(deck.picture(key)->brightness(), grey, 2) << "key " << key;
  }

  board::Writer<board::ButtonCalls> calls_ = board_.AcquireWriter<board::ButtonCalls>().value();
  board::Writer<board::Lamps> lamps_ = board_.AcquireWriter<board::Lamps>().value();
  board::Writer<board::ShowNow> show_now_ = board_.AcquireWriter<board::ShowNow>().value();
};

}  // namespace kaori::input
