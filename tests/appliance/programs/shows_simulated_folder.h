// A folder whose power can be cut at each of its steps, and a stick that can be pulled.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "appliance/programs/shows/folder.h"
#include "appliance/programs/shows/installation.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::shows {

using Bytes = std::vector<std::uint8_t>;

// What a disk has of a file that was not yet told to be kept, after a power cut.
enum class Torn : std::uint8_t { kEmpty, kHalf, kWhole, kZeros };

// Keeps what the program sees and what the disk has apart. A name reaches the disk by KeepNames, and may before; a
// content by Finish, and may in part before.
class SimulatedFolder final : public Folder {
 public:
  // Faults of the design that the tests must find.
  bool forgets_names = false, forgets_content = false;
  std::uint64_t capacity_bytes = std::uint64_t{64} << 20U;
  std::optional<int> steps_left;     // Until the power is cut; nothing: never.
  std::optional<std::errc> fault{};  // Of every further write, from now on.

  std::filesystem::path path() const override { return "/simulated"; }
  Result<std::uint64_t> FreeBytes() const override {
    return capacity_bytes - std::min(capacity_bytes, Used());
  }
  Result<std::vector<std::string>> Names() const override {
    std::vector<std::string> names;
    for (const auto& [name, file] : names_) names.push_back(name);
    return names;
  }
  std::uint64_t BytesOf(const std::string& name) const override { return Content(name).size(); }
  std::string Read(const std::string& name) const override {
    const auto bytes = Content(name);
    return {bytes.begin(), bytes.end()};
  }
  Result<std::unique_ptr<Draft>> Begin(const std::string& name) override {
    if (auto ok = Spend("begin " + name); !ok) return tl::unexpected(ok.error());
    files_.emplace_back();
    Link(name, files_.size() - 1);
    return std::make_unique<SimulatedDraft>(*this, files_.size() - 1);
  }
  Result<void> Rename(const std::string& from, const std::string& to) override {
    if (auto ok = Spend("rename " + from); !ok) return ok;
    const auto file = names_.at(from);
    pending_.push_back({.remove = from, .link = to, .file = file});
    names_.erase(from);
    names_[to] = file;
    return {};
  }
  Result<void> Remove(const std::string& name) override {
    if (!names_.contains(name)) return {};
    if (auto ok = Spend("remove " + name); !ok) return ok;
    names_.erase(name);
    pending_.push_back({.remove = name, .link = {}, .file = 0});
    return {};
  }
  Result<void> KeepNames() override {
    if (auto ok = Spend("keep names"); !ok) return ok;
    if (forgets_names) return {};
    for (const auto& change : pending_) change.ApplyTo(kept_);
    pending_.clear();
    return {};
  }

  Bytes Content(const std::string& name) const {
    const auto found = names_.find(name);
    return found == names_.end() ? Bytes() : files_[found->second].content;
  }
  // To be spoilt, as a disk does. The file is there.
  Bytes& ContentOf(const std::string& name) { return files_[names_.at(name)].content; }
  // How many changes of names the disk may have seen or not.
  std::size_t pending() const { return pending_.size(); }

  // The folder as it is found when the power is back: the disk has seen so many of the pending changes.
  SimulatedFolder AfterCut(std::size_t changes, Torn torn) const {
    SimulatedFolder after = *this;
    for (std::size_t i = 0; i < changes; ++i) pending_[i].ApplyTo(after.kept_);
    after.names_ = after.kept_;
    after.pending_.clear();
    after.steps_left.reset();
    after.fault.reset();
    for (auto& file : after.files_)
      if (!file.kept) file = {.content = TornTo(file.content, torn), .kept = true};
    return after;
  }

 private:
  struct File {
    Bytes content;
    bool kept = false;
  };
  struct Change {
    std::string remove, link;
    std::size_t file = 0;
    void ApplyTo(std::map<std::string, std::size_t>& names) const {
      names.erase(remove);
      if (!link.empty()) names[link] = file;
    }
  };
  class SimulatedDraft final : public Draft {
   public:
    SimulatedDraft(SimulatedFolder& folder, std::size_t file) : folder_(folder), file_(file) {}
    Result<void> Append(std::span<const std::uint8_t> bytes) override {
      if (auto ok = folder_.Spend("write"); !ok) return ok;
      if (folder_.Used() + bytes.size() > folder_.capacity_bytes)
        return Fail(std::errc::no_space_on_device, "write");
      auto& content = folder_.files_[file_].content;
      content.insert(content.end(), bytes.begin(), bytes.end());
      return {};
    }
    Result<void> Finish() override {
      if (auto ok = folder_.Spend("finish"); !ok) return ok;
      folder_.files_[file_].kept = !folder_.forgets_content;
      return {};
    }

   private:
    SimulatedFolder& folder_;
    std::size_t file_;
  };

  static Bytes TornTo(Bytes content, Torn torn) {
    if (torn == Torn::kEmpty) content.clear();
    if (torn == Torn::kHalf) content.resize(content.size() / 2);
    if (torn == Torn::kZeros) std::ranges::fill(content, std::uint8_t{0});
    return content;
  }
  Result<void> Spend(const std::string& what) {
    if (fault) return Fail(*fault, what);
    if (!steps_left) return {};
    if (*steps_left == 0) return Fail(std::errc::no_such_device, what + " without power");
    --*steps_left;
    return {};
  }
  void Link(const std::string& name, std::size_t file) {
    names_[name] = file;
    pending_.push_back({.remove = name, .link = name, .file = file});
  }
  std::uint64_t Used() const {
    std::uint64_t bytes = 0;
    for (const auto& [name, file] : names_) bytes += files_[file].content.size();
    return bytes;
  }

  std::vector<File> files_;
  std::map<std::string, std::size_t> names_, kept_;
  std::vector<Change> pending_;
};

// A file on a stick that ends, or is pulled, where the test wants it.
class SimulatedSource final : public Source {
 public:
  explicit SimulatedSource(Bytes content, std::optional<std::size_t> pulled_at = {}, std::uint64_t claims = 0)
      : content_(std::move(content)),
        pulled_at_(pulled_at),
        claims_(claims == 0 ? content_.size() : claims) {}
  std::uint64_t bytes() const override { return claims_; }
  Result<std::size_t> Read(std::span<std::uint8_t> into) override {
    if (pulled_at_ && at_ + into.size() > *pulled_at_) return Fail(std::errc::io_error, "read the stick");
    const std::size_t got = std::min(into.size(), content_.size() - at_);
    std::copy_n(content_.begin() + static_cast<std::ptrdiff_t>(at_), got, into.begin());
    at_ += got;
    return got;
  }

 private:
  Bytes content_;
  std::optional<std::size_t> pulled_at_;
  std::uint64_t claims_;
  std::size_t at_ = 0;
};

// Two signed shows of more than a piece each, whose packs differ, and the key of their company.
class InstallationTest : public tests::PackTest {
 protected:
  static Bytes PackOf(const std::string& name, const show::SecretKey* signer) {
    show::Show show = tests::SmallShow();
    show.name = name;
    constexpr int kSide = 560;
    show.cast.textures = {{kSide, kSide, Bytes(std::size_t{kSide} * kSide * 4, 200)}};
    return show::EncodePack(show, signer);
  }
  static std::string IdOf(const Bytes& pack) {
    std::string id;
    for (std::size_t i = 24; i < 56; ++i) id += fmt::format("{:02x}", pack[i]);
    return id;
  }
  Progress Install(Folder& folder, std::unique_ptr<Source> source, const Trial& trial = {}) const {
    const Trial always = [](const auto&) -> Result<void> { return {}; };
    Installation installation(folder, std::move(source), keys_, trial ? trial : always);
    while (!installation.ended()) installation.Step();
    return installation.progress();
  }
  Progress Install(Folder& folder, const Bytes& pack) const {
    return Install(folder, std::make_unique<SimulatedSource>(pack));
  }

  const show::SecretKey company_ = show::MakeKey().value();
  show::PublicKeys keys_{company_.public_key()};
  const Bytes first_ = PackOf("matinee", &company_), second_ = PackOf("evening", &company_);
};

}  // namespace kaori::shows
