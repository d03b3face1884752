#include "appliance/core/restore/apply.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <utility>
#include <vector>

#include "appliance/core/restore/plan.h"
#include "appliance/core/store/choice.h"
#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::restore {
namespace {

namespace fs = std::filesystem;

constexpr const char* kShowBefore = "show";  // In restore/kept.new: the id that was chosen before.
constexpr std::size_t kMostId_bytes = 128;

// What lies in a folder belongs to the folder's owner, who is the program that reads it.
void GiveToFolder(const fs::path& path) {
  struct stat folder {};
  if (::stat(path.parent_path().c_str(), &folder) == 0)
    static_cast<void>(::lchown(path.c_str(), folder.st_uid, folder.st_gid) == 0);
}

// One start's work at a restore. Each of its changes may be the last before the power goes: what the next start finds says how
// far it came, and none is done a second time.
class Application {
 public:
  Application(const fs::path& data, const BeforeChange& before) : data_(data), before_(before) {}

  // Ends with the plan of the way back whole, and that of the restore gone.
  Result<void> Do(const Plan& plan) {
    if (auto ok = NoteShowBefore(); !ok) return ok;
    for (const std::string& path : plan.removed)
      if (auto ok = MoveAway(path); !ok) return ok;
    for (const std::string& path : plan.put)
      if (auto ok = Put(path); !ok) return ok;
    if (auto ok = Choose(plan.show); !ok) return ok;
    if (auto ok = KeepNames(); !ok) return ok;
    if (auto ok = Write(data_ / kKeeping / kPlan, Format(WayBack(plan))); !ok) return ok;
    return Change([&] { return ::unlink((data_ / kNext / kPlan).c_str()); }, "finish the restore");
  }

  // The plan of the way back is whole, and that of the restore is gone.
  Result<void> Close() {
    if (IsThere(data_ / kKeeping / kPlan)) {
      if (auto ok = RemoveAll(data_ / kKept); !ok) return ok;
      if (auto ok = Rename(data_ / kKeeping, data_ / kKept); !ok) return ok;
    }
    if (auto ok = RemoveAll(data_ / kNext); !ok) return ok;
    return KeepNames();
  }

 private:
  template <class Call>
  Result<void> Change(const Call& call, std::string what) {
    if (before_)
      if (auto ok = before_(); !ok) return ok;
    if (call() != 0) return FailErrno(std::move(what));
    return {};
  }
  Result<void> Rename(const fs::path& from, const fs::path& to) {
    return Change([&] { return std::rename(from.c_str(), to.c_str()); }, "restore " + to.string());
  }
  // One after the other, what lies deepest first, so that a cut in the middle can be tried.
  Result<void> RemoveAll(const fs::path& folder) {
    if (!IsThere(folder)) return {};
    std::vector<fs::path> doomed{folder};
    std::error_code failed;
    for (fs::recursive_directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed))
      doomed.push_back(it->path());
    if (failed) return Fail(static_cast<std::errc>(failed.value()), "look at " + folder.string());
    for (auto each = doomed.rbegin(); each != doomed.rend(); ++each)
      if (auto ok = Change([&] { return std::remove(each->c_str()); }, "remove " + each->string()); !ok)
        return ok;
    return {};
  }
  Result<void> Write(const fs::path& file, const std::string& text) {
    if (before_)
      if (auto ok = before_(); !ok) return ok;
    return WriteWholeFile(file, {AsBytes(text)});
  }
  Result<void> MakeFolder(const fs::path& folder) {
    if (IsThere(folder)) return {};
    if (auto ok = MakeFolder(folder.parent_path()); !ok) return ok;
    auto made = Change([&] { return ::mkdir(folder.c_str(), 0755); }, "make " + folder.string());
    if (made) GiveToFolder(folder);
    return made;
  }
  // Once: where the power went after the choice, the show before is no longer the chosen one.
  Result<void> NoteShowBefore() {
    if (auto ok = MakeFolder(data_ / kKeeping / kFiles); !ok) return ok;
    if (IsThere(data_ / kKeeping / kShowBefore)) return {};
    return Write(data_ / kKeeping / kShowBefore, store::ReadChoice(data_ / "shows").current);
  }
  // What was taken away before the power went stays taken away.
  Result<void> MoveAway(const std::string& path) {
    const fs::path kept = data_ / kKeeping / kFiles / path;
    if (!IsThere(data_ / path) || IsThere(kept)) return {};
    if (auto ok = MakeFolder(kept.parent_path()); !ok) return ok;
    return Rename(data_ / path, kept);
  }
  // A file that waits no more was put before the power went.
  Result<void> Put(const std::string& path) {
    const fs::path waits = data_ / kNext / kFiles / path;
    if (!IsThere(waits)) return {};
    if (auto ok = MoveAway(path); !ok) return ok;
    if (auto ok = MakeFolder((data_ / path).parent_path()); !ok) return ok;
    if (auto ok = Rename(waits, data_ / path); !ok) return ok;
    GiveToFolder(data_ / path);
    return {};
  }
  // In the older of the two files, as whoever installs a show does.
  Result<void> Choose(const std::string& show) {
    const fs::path shows = data_ / "shows";
    const store::Choice now = store::ReadChoice(shows);
    if (show.empty() || show == now.current) return {};
    if (auto ok = MakeFolder(shows); !ok) return ok;
    const store::Choice next{store::NextGeneration(now, 0), show, now.current};
    return Write(shows / store::kChoiceFiles[next.generation % 2], store::Format(next));
  }
  // Renames reach the disk in their order, and all of them before the plan goes.
  Result<void> KeepNames() { return SyncFileSystem(data_); }
  Plan WayBack(const Plan& plan) const {
    Plan back;
    if (!plan.show.empty())
      back.show =
          ReadFile(data_ / kKeeping / kShowBefore, {.most_bytes = kMostId_bytes}).value_or(std::string());
    const auto add = [&](const std::string& path) {
      (IsThere(data_ / kKeeping / kFiles / path) ? back.put : back.removed).push_back(path);
    };
    for (const std::string& path : plan.put) add(path);
    for (const std::string& path : plan.removed) add(path);
    return back;
  }

  const fs::path& data_;
  const BeforeChange& before_;
};

}  // namespace

Result<bool> FinishRestore(const fs::path& data, const BeforeChange& before) {
  const bool waits = IsThere(data / kNext), keeps = IsThere(data / kKeeping);
  if (!waits && !keeps) return false;
  Application application(data, before);
  if (IsThere(data / kNext / kPlan)) {
    const auto text = ReadFile(data / kNext / kPlan, {.most_bytes = kMostPlan_bytes});
    if (!text) return tl::unexpected(text.error());
    const auto plan = ParsePlan(*text);
    if (!plan)
      return FailInput("the restore that waits has a damaged plan; take it again", std::errc::bad_message);
    if (auto ok = application.Do(*plan); !ok) return tl::unexpected(ok.error());
  }
  if (auto ok = application.Close(); !ok) return tl::unexpected(ok.error());
  return true;
}

}  // namespace kaori::restore
