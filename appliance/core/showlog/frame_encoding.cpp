#include "appliance/core/showlog/frame_encoding.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "drivers/base/checksum.h"

namespace kaori::showlog {
namespace {

using performance::InputEvents;

// Behind the sections.
constexpr std::size_t kEventsAt =
    kFrameWords - internal::kWordsOf<performance::SeenInput> - internal::kWordsOf<InputEvents>;

// Lays one value after the other into words.
class Packer {
 public:
  explicit Packer(std::uint32_t* at) : at_(at) {}
  template <class T>
  void Put(const T& value) {
    std::memcpy(at_, &value, sizeof(T));
    at_ += internal::kWordsOf<T>;
  }
  void Skip(std::size_t words) { at_ += words; }

 private:
  std::uint32_t* at_;
};

// And takes them out again.
class Unpacker {
 public:
  explicit Unpacker(const std::uint32_t* at) : at_(at) {}
  template <class T>
  void Get(T& value) {
    std::memcpy(static_cast<void*>(&value), at_, sizeof(T));
    at_ += internal::kWordsOf<T>;
  }

 private:
  const std::uint32_t* at_;
};

// Most frames have none, and then unused bytes between fields must not count as changes.
bool HasNothing(const InputEvents& events) {
  const auto still = [](std::int32_t turned) { return turned == 0; };
  return events.presses().empty() && events.calls().empty() && events.lost_calls() == 0 &&
         std::ranges::all_of(events.turned, still) && !events.pointer.pressed &&
         events.pointer.moved == glm::vec2() && events.pointer.notches == 0 && !events.week_minute;
}

}  // namespace

// The board's layout, the state's own number and both lengths. Fields that trade places unseen by all of
// these are why State::kLayout is raised by hand.
std::uint64_t WordsLayout() {
  std::uint64_t hash = board::LayoutHash();
  for (const std::size_t part : {std::size_t{performance::State::kLayout}, kStateWords, kFrameWords})
    for (unsigned shift = 0; shift < 32; shift += 8)
      hash = Fnv1a(std::array{static_cast<std::uint8_t>(part >> shift)}, hash);
  return hash;
}

// The age of a section that was not written stays in its words as it was: it says nothing.
void PackFrame(Time presented_at, const board::Snapshot& board, FrameTimes& times, FrameWords& into) {
  Packer packer(into.data());
  packer.Put(presented_at - times.presented_at);
  times.presented_at = presented_at;
  Packer bits_packer = packer;
  packer.Skip(1);
  std::uint32_t bits = 0, bit = 1;
  std::size_t nth = 0;
  ForSections(board, [&](const auto& section) {
    Time& stamp = times.stamps[nth++];
    if (section.at != stamp) {
      bits |= bit;
      packer.Put(presented_at - section.at);
      stamp = section.at;
    } else {
      packer.Skip(internal::kWordsOf<Duration>);
    }
    bit <<= 1U;
    packer.Put(section.source);
    packer.Put(section.value);
  });
  bits_packer.Put(bits);
}

void PackEvents(const performance::SeenInput& seen, const InputEvents& events, FrameWords& into) {
  Packer packer(into.data() + kEventsAt);
  packer.Put(seen);
  packer.Put(HasNothing(events) ? InputEvents() : events);
}

// Field by field, since the bytes between them may differ; values of calls by their bits, so that -0 is not
// 0.
bool IsSame(const InputEvents& a, const InputEvents& b) {
  const auto same_press = [](const performance::Press& x, const performance::Press& y) {
    return x.source == y.source && x.code == y.code && x.shift == y.shift && x.at_us == y.at_us;
  };
  const auto same_call = [](const board::Call& x, const board::Call& y) {
    return x.at == y.at && x.verb == y.verb && x.subject == y.subject && x.source == y.source &&
           std::bit_cast<std::uint32_t>(x.value) == std::bit_cast<std::uint32_t>(y.value);
  };
  return std::ranges::equal(a.presses(), b.presses(), same_press) &&
         std::ranges::equal(a.calls(), b.calls(), same_call) && a.lost_calls() == b.lost_calls() &&
         a.turned == b.turned && a.pointer.pressed == b.pointer.pressed &&
         a.pointer.moved == b.pointer.moved && a.pointer.notches == b.pointer.notches &&
         a.week_minute == b.week_minute;
}

void PackState(const performance::State& state, StateWords& into) {
  std::memcpy(into.data(), &state, sizeof(state));
}

// Sums of what a forged log holds may run over: they are made of unsigned numbers, and judged afterwards.
bool UnpackFrame(const FrameWords& words, FrameTimes& times, FrameInput& into) {
  const auto plus = [](Time time, std::uint64_t by_ns) {
    const auto sum = static_cast<std::uint64_t>(time.time_since_epoch().count()) + by_ns;
    return Time{} + Duration(static_cast<std::int64_t>(sum));
  };
  Unpacker unpacker(words.data());
  std::uint64_t ns = 0;
  unpacker.Get(ns);
  into.presented_at = times.presented_at = plus(times.presented_at, ns);
  bool valid = board::Valid(into.presented_at);
  std::uint32_t bits = 0;
  unpacker.Get(bits);
  std::size_t nth = 0;
  ForSections(into.board, [&](auto& section) {
    Time& stamp = times.stamps[nth];
    unpacker.Get(ns);
    if ((bits >> nth & 1U) != 0) stamp = plus(into.presented_at, 0 - ns);
    section.at = stamp;
    unpacker.Get(section.source);
    unpacker.Get(section.value);
    ++nth;
    valid = valid && board::Valid(section.at) && board::Valid(section.source) && board::Valid(section.value);
  });
  unpacker.Get(into.seen);
  unpacker.Get(into.events);
  const auto known = [](const board::Call& call) {
    return static_cast<std::uint32_t>(call.verb) < board::kCallVerbCount;
  };
  const auto there_is = [](const performance::Press& press) {
    return press.source <= performance::Press::Source::kKey &&
           (press.IsKey() || press.code < show::kAllButtonCount);
  };
  return valid && into.events.presses().size() <= InputEvents::kMostPresses &&
         std::ranges::all_of(into.events.presses(), there_is) &&
         into.events.calls().size() <= InputEvents::kMostCalls &&
         std::ranges::all_of(into.events.calls(), known) &&
         (!into.events.week_minute || (*into.events.week_minute >= performance::kNoWeekMinute &&
                                       *into.events.week_minute < show::kWeekMinutes));
}

performance::State UnpackState(const StateWords& words) {
  performance::State state;
  std::memcpy(static_cast<void*>(&state), words.data(), sizeof(state));
  return state;
}

}  // namespace kaori::showlog
