// States of the buttons that no report has told yet, so that no press between two polls of a host is lost.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kaori::surface {

// A button that went down and up again between two reports gets both its reports; what changes beside it
// shares them. One side.
class ButtonLog {
 public:
  // Beyond this many states edges merge: a host that is away for a third of a second loses none of a
  // person's.
  static constexpr std::size_t kStates = 64;

  // Bit n of `pressed`: button n is pressed now. Where no host listens, all shares one report.
  void Note(std::uint32_t pressed, bool hosted);
  // Whether a report has something to say.
  bool empty() const { return count_ == 0; }
  // What the next report says, and it counts as told.
  std::uint32_t Next();
  // What the last report said, and how things stand.
  std::uint32_t told() const { return told_; }
  std::uint32_t newest() const { return count_ == 0 ? told_ : at(count_ - 1); }
  // A host came that knows nothing, or only what was told before: one report says how things stand, where a
  // button is pressed or something waited.
  void Restart();

 private:
  std::uint32_t at(std::size_t place) const { return states_[(first_ + place) % kStates]; }
  void Append(std::uint32_t pressed);

  std::uint32_t told_ = 0;
  std::array<std::uint32_t, kStates> states_{};  // A ring.
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace kaori::surface
