// Copies arrays out of a FlatBuffer, and never more bytes than it has: tables of a forged one may share
// theirs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "appliance/core/show/pack_layout.h"

namespace kaori::show {

// What does not fit becomes the largest number that does, and CheckShow finds that to be too large.
template <class To>
To Narrow(std::uint32_t value) {
  return static_cast<To>(std::min<std::uint32_t>(value, std::numeric_limits<To>::max()));
}

// Absent arrays read as empty, and so does everything once too much was asked for: CheckShow says what is
// missing. Used for one content, by one thread; what it gives is independent of the content but for Texels.
class Copier {
 public:
  // Textures stay where they are while `keeper` lives; without one they are copied too.
  explicit Copier(std::size_t bytes_at_most, std::shared_ptr<const void> keeper = nullptr)
      : left_(bytes_at_most), keeper_(std::move(keeper)) {}

  // More was asked for than the content has: its tables share arrays, which no pack of ours does. Everything
  // that was read is to be thrown away then.
  bool overdrawn() const { return overdrawn_; }

  // An array of plain structs, moved by one copy: SameBytes says that both have the same layout.
  template <class Held, class Stored>
  std::vector<Held> Structs(const flatbuffers::Vector<const Stored*>* stored) {
    SameBytes<Stored, Held>();
    if (stored == nullptr || !Reserve(stored->size() * sizeof(Held))) return {};
    std::vector<Held> held(stored->size());
    if (!held.empty()) std::memcpy(held.data(), stored->Data(), held.size() * sizeof(Held));
    return held;
  }

  // An array of plain numbers. Whether they are finite and in range is for CheckShow to find.
  template <class T>
  std::vector<T> Numbers(const flatbuffers::Vector<T>* stored) {
    if (stored == nullptr || !Reserve(stored->size() * sizeof(T))) return {};
    return {stored->data(), stored->data() + stored->size()};
  }

  // The pixels of a texture, where they lie as long as the keeper lives. They count against the budget too.
  face::Texels Texels(const flatbuffers::Vector<std::uint8_t>* stored) {
    if (!keeper_) return Numbers(stored);
    if (stored == nullptr || !Reserve(stored->size())) return {};
    return {std::span(stored->data(), stored->size()), keeper_};
  }

  // A text, whatever its bytes; names are checked by nobody and are shown to people only.
  std::string Text(const flatbuffers::String* stored) {
    return stored == nullptr || !Reserve(stored->size()) ? std::string() : stored->str();
  }

  // One value for each table of a list, as `read(copier, table)` makes it. Only the offsets count here: `read` takes what
  // the table holds off the same budget, also where several offsets lead to one table.
  template <class To, class Stored, class Read>
  std::vector<To> Tables(const flatbuffers::Vector<flatbuffers::Offset<Stored>>* stored, Read read) {
    std::vector<To> all;
    if (stored == nullptr || !Reserve(stored->size() * sizeof(flatbuffers::uoffset_t))) return all;
    all.reserve(stored->size());
    for (const Stored* one : *stored) all.push_back(read(*this, *one));
    return all;
  }

 private:
  // Takes `bytes` off the budget, and gives whether they were there; once they were not, no more are given.
  bool Reserve(std::size_t bytes) {
    overdrawn_ = overdrawn_ || bytes > left_;
    if (!overdrawn_) left_ -= bytes;
    return !overdrawn_;
  }

  std::size_t left_;                    // Bytes that may still be copied, or lent.
  std::shared_ptr<const void> keeper_;  // Null: textures are copied as well.
  bool overdrawn_ = false;              // Never false again.
};

}  // namespace kaori::show
