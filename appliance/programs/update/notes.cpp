#include "appliance/programs/update/notes.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::update {
namespace {

constexpr std::size_t kMostLastTry_bytes = std::size_t{128} << 10U;
// A last try with its log, the three short notes, and what the file system needs for their names.
constexpr std::size_t kReserved_bytes = kMostLastTry_bytes + (std::size_t{32} << 10U);
constexpr const char* kReserved = "reserved";
constexpr const char* kOverwritten = "overwritten";

class NotesFolder final : public Notes {
 public:
  explicit NotesFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::optional<Pending> ReadPending() const override { return update::ReadPending(folder_ / "pending"); }
  Result<void> KeepPending(const Pending& pending) override { return Keep("pending", Format(pending)); }
  Result<void> ForgetPending() override { return Remove("pending"); }
  std::optional<Pending> ReadBefore() const override { return update::ReadPending(folder_ / "before"); }
  Result<void> KeepBefore(const Pending& before) override { return Keep("before", Format(before)); }
  Result<void> BeginOverwriting() override {
    if (::rename((folder_ / "before").c_str(), (folder_ / kOverwritten).c_str()) < 0)
      return errno == ENOENT ? Result<void>{} : FailErrno("rename " + (folder_ / "before").string());
    return SyncFolder(folder_);
  }
  Result<void> EndOverwriting() override { return Remove(kOverwritten); }
  std::optional<Pending> ReadOverwritten() const override {
    return update::ReadPending(folder_ / kOverwritten);
  }
  std::string ReadLastTry() const override {
    return ReadBeginning(folder_ / "last-try", kMostLastTry_bytes).value_or("");
  }
  Result<void> KeepLastTry(std::string_view text) override {
    return text.empty() ? Remove("last-try") : Keep("last-try", text);
  }

  // Zeros are blocks of the disk as well: the file is written, and has no holes.
  Result<void> Reserve() override {
    std::error_code none;
    if (std::filesystem::file_size(folder_ / kReserved, none) == kReserved_bytes && !none) return {};
    return Write(kReserved, std::string(kReserved_bytes, '\0'));
  }

 private:
  Result<void> Write(const char* name, std::string_view text) {
    std::error_code none;  // Where it cannot be made, the writing says why.
    std::filesystem::create_directories(folder_, none);
    return WriteWholeFile(folder_ / name, {AsBytes(text)});
  }
  // On a full disk what was reserved makes room.
  Result<void> Keep(const char* name, std::string_view text) {
    auto kept = Write(name, text);
    if (kept || kept.error().cause != std::errc::no_space_on_device) return kept;
    if (auto freed = Remove(kReserved); !freed) return freed;
    return Write(name, text);
  }
  // A name that is gone is on the disk with its folder.
  Result<void> Remove(const char* name) {
    if (::unlink((folder_ / name).c_str()) < 0)
      return errno == ENOENT ? Result<void>{} : FailErrno("remove " + (folder_ / name).string());
    return SyncFolder(folder_);
  }

  std::filesystem::path folder_;
};

}  // namespace

std::unique_ptr<Notes> OpenNotes(const std::filesystem::path& folder) {
  return std::make_unique<NotesFolder>(folder);
}

}  // namespace kaori::update
