// What the keys of a Stream Deck show: pictures of what they call, lit while it is on.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <vector>

#include "appliance/programs/input/transfer_failures.h"
#include "drivers/base/clock.h"
#include "drivers/decode/stream_deck.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::input {

// What a key is to show.
struct DeckKey {
  std::uint64_t call = 0;  // board::ButtonCalls; 0: nothing.
  bool is_lit = false;
  friend bool operator==(const DeckKey&, const DeckKey&) = default;
};

// A key's picture is the first of these files that is there, each with "-lit" at the end of its name while the
// key is lit, or without where there is no such file:
//   FOLDER/5.jpg              of the fifth key, whatever it calls: somebody wrote it for this box
//   SHOW/72/SUM.jpg           of what it calls, by the size of the deck's keys: brought by the show that plays
//   FOLDER/72/SUM.jpg         the same (kaori-atelier keys)
//   SHOW/72/blank.jpg, FOLDER/72/blank.jpg
// A key without any stays as it is. Of a Mini they end in ".bmp". Pictures are sent page by page, so that nothing
// waits for a deck. One thread.
class DeckPictures {
 public:
  static constexpr std::size_t kMostKeys = 32;
  using Keys = std::array<DeckKey, kMostKeys>;

  // A deck came, whose keys show nothing of ours; one of 0 keys is none. An empty folder: no pictures, or none of the show's.
  void Plug(const decode::StreamDeck& deck, std::filesystem::path folder, std::filesystem::path of_show = {});
  // Nothing is shown from here on.
  void Unplug() { deck_ = {}; }
  bool has_keys() const { return deck_.keys > 0; }

  // Sends at most one page, so that the keys come to show this; to be called every few milliseconds. Reads a
  // file where a key changes, and says in the log, once a plug each, what is wrong: a file that cannot be
  // read, a deck that is slow, one that takes no picture at the third try in a minute. `name` is for the log.
  void Show(const Keys& keys, Time now, ports::HidChannel& device, std::string_view name);

 private:
  // Loads the next key that shows something else than it is to; false: there is none.
  bool Begin(const Keys& keys);
  std::vector<std::uint8_t> Load(std::size_t key, const DeckKey& wanted);
  // Nothing: there is no such file, or it cannot be read.
  std::optional<std::vector<std::uint8_t>> Read(const std::filesystem::path& file);
  void HandleFailure(const Error& error, Time now, std::string_view name);

  decode::StreamDeck deck_{};
  std::filesystem::path folder_, of_show_;
  std::array<std::optional<DeckKey>, kMostKeys> shown_{};
  // The key whose pages are being sent, and those that are left.
  std::size_t key_ = 0;
  DeckKey coming_{};
  std::vector<std::vector<std::uint8_t>> pages_;
  std::size_t next_page_ = 0;
  std::optional<Time> waits_since_;  // The deck has not taken the page before.
  bool told_slow_ = false;
  TransferFailures failures_;
  Time not_before_{};
  std::set<std::filesystem::path> told_files_;
};

}  // namespace kaori::input
