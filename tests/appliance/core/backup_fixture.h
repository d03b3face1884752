// A data partition with all that a backup has, and backups of it as bytes.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "appliance/core/backup/writer.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::backup {

// A backup as a text, that ends or is pulled where the test wants it.
class TextInput final : public Input {
 public:
  explicit TextInput(std::string text, std::size_t pulled_at = SIZE_MAX)
      : text_(std::move(text)), pulled_at_(pulled_at) {}
  Result<std::size_t> Read(std::span<std::uint8_t> into) override {
    if (at_ + into.size() > pulled_at_) return Fail(std::errc::io_error, "read the stick");
    const std::size_t got = std::min(into.size(), text_.size() - at_);
    if (got > 0) std::memcpy(into.data(), text_.data() + at_, got);
    at_ += got;
    return got;
  }

 private:
  std::string text_;
  std::size_t pulled_at_, at_ = 0;
};

// Keeps what a reader gives, by paths.
class Collected final : public Sink {
 public:
  Result<void> Begin(const Entry& entry) override {
    path_ = entry.member.path;
    return {};
  }
  Result<void> Append(std::span<const std::uint8_t> bytes) override {
    files[path_].append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return {};
  }
  Result<void> End(const Entry&) override {
    ++whole;
    return {};
  }
  std::map<std::string, std::string> files;
  std::size_t whole = 0;

 private:
  std::string path_;
};

class BackupTest : public ::testing::Test {
 protected:
  BackupTest() {
    Put("settings/box.toml", "profile = \"stage\"\n");
    Put("settings/keys/company.pub", "a key");
    Put("settings/box.last-good.toml", "made anew");
    Put("own/01-smile.toml", "smile");
    Put("own/last-face", "her face");
    Put("own/log/2026-11-23", "a report");
    Put("lips/lips.settings", std::string(5000, 'l'));
    Put("machine-id", "0123456789abcdef");
    std::filesystem::create_directories(folder_ / "stick");
  }
  ~BackupTest() override { std::filesystem::remove_all(folder_); }

  void Put(const std::string& path, const std::string& text) const {
    std::filesystem::create_directories((data_ / path).parent_path());
    std::ofstream(data_ / path) << text;
  }
  // Errors: those of the writer.
  Result<std::string> Write() const {
    std::filesystem::remove(file_);
    auto writer = Writer::Begin(data_, {"kaori-1a2b3c4d", "2026-11-23 22:10:05 +0900"}, file_);
    if (!writer) return tl::unexpected(writer.error());
    for (Result<bool> done = false; !*done;)
      if (done = writer->Step(); !done) return tl::unexpected(done.error());
    return ReadFile(file_, {.most_bytes = std::size_t{64} << 20U});
  }
  static Result<void> Read(std::unique_ptr<Input> input, Sink& sink) {
    auto reader = Reader::Begin(std::move(input));
    if (!reader) return tl::unexpected(reader.error());
    for (Result<bool> done = false; !*done;)
      if (done = reader->Step(sink); !done) return tl::unexpected(done.error());
    return {};
  }
  static Result<void> Read(const std::string& text) {
    Collected sink;
    return Read(std::make_unique<TextInput>(text), sink);
  }
  // An archive of this list and nothing else.
  static std::string OfList(const std::string& list) {
    const Block block = MakeBlock({std::string(kContents), list.size()});
    return std::string(block.begin(), block.end()) + list +
           std::string(Padding(list.size()) + 2 * kBlock_bytes, '\0');
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("backup-test-" + std::to_string(::getpid()));
  const std::filesystem::path data_ = folder_ / "data", file_ = folder_ / "stick/box.kaorishow";
};

}  // namespace kaori::backup
