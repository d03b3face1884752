#include "appliance/programs/update/notes.h"

#include <unistd.h>

#include <utility>

#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::update {
namespace {

constexpr std::size_t kMostPending_bytes = 64;
constexpr std::size_t kMostLastTry_bytes = std::size_t{128} << 10U;

class NotesFolder final : public Notes {
 public:
  explicit NotesFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::optional<Pending> ReadPending() const override {
    return ParsePending(ReadFile(folder_ / "pending", {.most_bytes = kMostPending_bytes}).value_or(""));
  }
  Result<void> KeepPending(const Pending& pending) override { return Keep("pending", Format(pending)); }
  Result<void> ForgetPending() override { return Remove("pending"); }
  std::string ReadLastTry() const override {
    return ReadBeginning(folder_ / "last-try", kMostLastTry_bytes).value_or("");
  }
  Result<void> KeepLastTry(std::string_view text) override {
    return text.empty() ? Remove("last-try") : Keep("last-try", text);
  }

 private:
  Result<void> Keep(const char* name, std::string_view text) {
    std::error_code none;  // Where it cannot be made, the writing says why.
    std::filesystem::create_directories(folder_, none);
    return WriteWholeFile(folder_ / name, {AsBytes(text)});
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
