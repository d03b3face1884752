// A backup from anybody's stick. Each input is read as a whole archive, as a list of contents with a right checksum, or
// nothing would come past that, and as the plan of a restore.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "appliance/core/backup/reader.h"
#include "appliance/core/restore/kept.h"
#include "appliance/core/restore/plan.h"
#include "tests/fuzz/check.h"

namespace {

namespace backup = kaori::backup;
using kaori::Result;

class Bytes final : public backup::Input {
 public:
  explicit Bytes(std::string_view bytes) : left_(bytes) {}
  Result<std::size_t> Read(std::span<std::uint8_t> into) override {
    const std::size_t got = std::min(into.size(), left_.size());
    if (got > 0) std::memcpy(into.data(), left_.data(), got);
    left_.remove_prefix(got);
    return got;
  }

 private:
  std::string_view left_;
};

bool BelongsToABox(std::string_view path) {
  return path.find("/.") == std::string_view::npos && path.front() != '/' &&
         (kaori::restore::IsRestored(path) || kaori::restore::IsPack(path) || kaori::restore::IsReport(path));
}

class Judge final : public backup::Sink {
 public:
  Result<void> Begin(const backup::Entry& entry) override {
    kaori::fuzz::Promise(BelongsToABox(entry.member.path), "no file leads out of the box's folders");
    left_bytes_ = entry.member.bytes;
    return {};
  }
  Result<void> Append(std::span<const std::uint8_t> bytes) override {
    kaori::fuzz::Promise(bytes.size() <= left_bytes_, "a file is no longer than its list says");
    left_bytes_ -= bytes.size();
    return {};
  }
  Result<void> End(const backup::Entry&) override {
    kaori::fuzz::Promise(left_bytes_ == 0, "a file is whole");
    return {};
  }

 private:
  std::uint64_t left_bytes_ = 0;
};

void ReadArchive(std::string_view bytes) {
  auto reader = backup::Reader::Begin(std::make_unique<Bytes>(bytes));
  Judge judge;
  for (Result<bool> done = false; reader && done && !*done;) done = reader->Step(judge);
}

void ReadList(std::string_view lines) {
  const std::string text = "kaori-backup 1\n" + std::string(lines) + "\n";
  backup::Sha256 sum;
  sum.Add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  const auto contents = backup::ParseContents(text + "sum " + sum.Finish() + "\n");
  if (!contents) return;
  for (const auto& entry : contents->files)
    kaori::fuzz::Promise(BelongsToABox(entry.member.path), "no list leads out of the box's folders");
  kaori::fuzz::Promise(backup::ParseContents(backup::Format(*contents)) == *contents,
                       "what was read can be written");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  ReadArchive(bytes);
  ReadList(bytes);
  static_cast<void>(kaori::restore::ParsePlan(bytes));
  return 0;
}
