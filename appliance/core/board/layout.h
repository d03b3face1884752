// Where each section lies on the board: computed once, and hashed so that no two programs disagree.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "appliance/core/board/sections.h"
#include "appliance/core/board/slots.h"
#include "drivers/base/checksum.h"

namespace kaori::board {

// The sections in the order in which they lie in the file, which is that of kPlaces. A section that is added,
// moved or resized changes LayoutHash, and old and new programs then refuse each other's boards.
enum class Section : std::uint32_t {
  kSurface,
  kStickLeft,
  kStickRight,
  kKeys,
  kLines,
  kCallsOfInput,
  kCallsOfControl,
  kPointer,
  kLips,
  kVoice,
  kSound,
  kMotionNow,
  kLipsGuide,
  kDesk,
  kMidiHeard,
  kLamps,
  kButtonCalls,
  kStageStatus,
  kShowNow,
  kLineCheck,
  kLearn,
  kShowsMenu,
  kPerformance,
};
inline constexpr std::size_t kSectionCount = 23;

// The file's head, in 32-bit words: magic, version, layout hash (low, high), size in bytes, and the sum of
// these; the rest is zero. The sum tells a board of another build from one that is spoilt.
inline constexpr std::uint32_t kMagic = 0x52414F4B;  // "KOAR" backwards: no text file starts so.
// Raised when the head or the slots change in a way that the layout hash cannot tell, as when the head got
// its sum.
inline constexpr std::uint32_t kVersion = 3;
inline constexpr std::size_t kHeadWords = 16;
inline constexpr std::size_t kHeadSumAt = 5;

// The lower half of the checksum of the words in front of the sum.
constexpr std::uint32_t HeadSum(std::span<const std::uint32_t, kHeadSumAt> words) {
  std::uint64_t sum = kFnvBasis;
  for (const std::uint32_t word : words)
    for (unsigned shift = 0; shift < 32; shift += 8)
      sum = Fnv1a(std::array{static_cast<std::uint8_t>(word >> shift)}, sum);
  return static_cast<std::uint32_t>(sum);
}

// Where one section lies. Lengths are in 32-bit words; section heads and slots are padded to cache lines by
// slots.h.
struct SectionPlace {
  std::string_view name;
  std::size_t value_words = 0;  // Stamp and value.
  std::size_t at_word = 0;      // From the start of the file.
};

// In front of every value: the time stamp in two words, the state of its source, and one word that is zero.
// Four words keep a value that begins with a 64-bit number aligned.
inline constexpr std::size_t kStampWords = 4;

namespace internal {

// Length of a stamped T. The board copies values word by word, so T has neither pointers nor odd bytes.
template <class T>
constexpr std::size_t ValueWords() {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(std::uint32_t) == 0);
  return kStampWords + sizeof(T) / sizeof(std::uint32_t);
}

// The names stand in error messages and in the layout hash; sections follow each other without gaps.
constexpr std::array<SectionPlace, kSectionCount> PlaceSections() {
  std::array<SectionPlace, kSectionCount> places{{{"surface", ValueWords<Surface>()},
                                                  {"stick left", ValueWords<Stick>()},
                                                  {"stick right", ValueWords<Stick>()},
                                                  {"keys", ValueWords<Keys>()},
                                                  {"lines", ValueWords<Lines>()},
                                                  {"calls of input", ValueWords<Calls>()},
                                                  {"calls of control", ValueWords<Calls>()},
                                                  {"pointer", ValueWords<Pointer>()},
                                                  {"lips", ValueWords<Lips>()},
                                                  {"voice", ValueWords<Voice>()},
                                                  {"sound", ValueWords<Sound>()},
                                                  {"motion_now", ValueWords<MotionNow>()},
                                                  {"lips_guide", ValueWords<LipsGuide>()},
                                                  {"desk", ValueWords<Desk>()},
                                                  {"midi_heard", ValueWords<MidiHeard>()},
                                                  {"lamps", ValueWords<Lamps>()},
                                                  {"button_calls", ValueWords<ButtonCalls>()},
                                                  {"stage_status", ValueWords<StageStatus>()},
                                                  {"show_now", ValueWords<ShowNow>()},
                                                  {"line_check", ValueWords<LineCheck>()},
                                                  {"learn", ValueWords<Learn>()},
                                                  {"shows_menu", ValueWords<ShowsMenu>()},
                                                  {"performance", ValueWords<Performance>()}}};
  std::size_t at = kHeadWords;
  for (SectionPlace& place : places) {
    place.at_word = at;
    at += SectionWords(place.value_words);
  }
  return places;
}

}  // namespace internal

// The whole board as this build has it: about 67 KB, most of it four copies of `performance`.
inline constexpr std::array<SectionPlace, kSectionCount> kPlaces = internal::PlaceSections();
inline constexpr std::size_t kBoardWords = kPlaces.back().at_word + SectionWords(kPlaces.back().value_words);
inline constexpr std::size_t kBoardBytes = kBoardWords * sizeof(std::uint32_t);

// Where a section lies. `section` is one of the enumerators.
constexpr const SectionPlace& Place(Section section) {
  return kPlaces[static_cast<std::size_t>(section)];
}

// A sum over names and sizes: two programs built from different sections never share a board. Fields that
// change their meaning but not the size of their struct are not seen by it; kVersion tells those.
constexpr std::uint64_t LayoutHash() {
  std::uint64_t hash = kFnvBasis;
  for (const SectionPlace& place : kPlaces) {
    const std::array<std::uint8_t, 2> words{static_cast<std::uint8_t>(place.value_words),
                                            static_cast<std::uint8_t>(place.value_words >> 8)};
    hash = Fnv1a(words, Fnv1a(place.name, hash));
  }
  return hash;
}

// Which section holds a T; the sticks are told apart by `which`, and so are the writers of calls
// (CallWriter). A type that no section holds does not compile, since the function then returns nothing.
template <class T>
constexpr Section SectionOf(int which) {
  if constexpr (std::is_same_v<T, Surface>) return Section::kSurface;
  if constexpr (std::is_same_v<T, Stick>) return which == 0 ? Section::kStickLeft : Section::kStickRight;
  if constexpr (std::is_same_v<T, Keys>) return Section::kKeys;
  if constexpr (std::is_same_v<T, Lines>) return Section::kLines;
  if constexpr (std::is_same_v<T, Calls>)
    return which == 0 ? Section::kCallsOfInput : Section::kCallsOfControl;
  if constexpr (std::is_same_v<T, Pointer>) return Section::kPointer;
  if constexpr (std::is_same_v<T, Lips>) return Section::kLips;
  if constexpr (std::is_same_v<T, MidiHeard>) return Section::kMidiHeard;
  if constexpr (std::is_same_v<T, Lamps>) return Section::kLamps;
  if constexpr (std::is_same_v<T, ButtonCalls>) return Section::kButtonCalls;
  if constexpr (std::is_same_v<T, Voice>) return Section::kVoice;
  if constexpr (std::is_same_v<T, Sound>) return Section::kSound;
  if constexpr (std::is_same_v<T, MotionNow>) return Section::kMotionNow;
  if constexpr (std::is_same_v<T, LipsGuide>) return Section::kLipsGuide;
  if constexpr (std::is_same_v<T, Desk>) return Section::kDesk;
  if constexpr (std::is_same_v<T, StageStatus>) return Section::kStageStatus;
  if constexpr (std::is_same_v<T, ShowNow>) return Section::kShowNow;
  if constexpr (std::is_same_v<T, LineCheck>) return Section::kLineCheck;
  if constexpr (std::is_same_v<T, Learn>) return Section::kLearn;
  if constexpr (std::is_same_v<T, ShowsMenu>) return Section::kShowsMenu;
  if constexpr (std::is_same_v<T, Performance>) return Section::kPerformance;
}

}  // namespace kaori::board
