// A restore at the start of a box: what is put, taken away and chosen, the way back, and a power cut between any two changes.
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <map>

#include "appliance/core/restore/apply.h"
#include "appliance/core/restore/kept.h"
#include "appliance/core/restore/plan.h"
#include "appliance/core/store/choice.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::restore {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

// What people see of a box: each file of theirs with its content, and the chosen show.
using Box = std::map<std::string, std::string>;

class RestoreTest : public ::testing::Test {
 protected:
  RestoreTest() { Renew(); }
  ~RestoreTest() override { fs::remove_all(folder_); }

  void Put(const std::string& path, const std::string& text) {
    fs::create_directories((data_ / path).parent_path());
    std::ofstream(data_ / path) << text;
  }
  // A box with a show, a restore that waits, and what the one before took away.
  void Renew() {
    fs::remove_all(folder_);
    Put("settings/box.toml", "old settings");
    Put("own/01-old.toml", "goes");
    Put("own/02-same.toml", "stays");
    Put("machine-id", "0123");
    Put("shows/" + std::string(store::kChoiceFiles[0]),
        store::Format({2, old_, std::string(store::kRootShow)}));
    Put("shows/" + store::PackName(old_), "old pack");
    const Plan plan{new_,
                    {"settings/box.toml", "settings/keys/company.pub", "own/03-new.toml",
                     "shows/" + store::PackName(new_)},
                    {"own/01-old.toml"}};
    for (const std::string& path : plan.put) Put(std::string(kNext) + "/files/" + path, "new " + path);
    Put(std::string(kNext) + "/plan", Format(plan));
    Put(std::string(kKept) + "/plan", Format(Plan{{}, {"own/04-older.toml"}, {}}));
    Put(std::string(kKept) + "/files/own/04-older.toml", "of the restore before");
  }
  Box Look() const {
    Box box{{"chosen", store::ReadChoice(data_ / "shows").current}};
    const auto paths = RestoredPaths(data_).value();
    for (const std::string& path : paths) box[path] = ReadFile(data_ / path).value();
    for (const std::string& id : {old_, new_})
      if (fs::exists(data_ / "shows" / store::PackName(id))) box["pack " + id.substr(0, 1)] = "there";
    return box;
  }
  // The power goes at the change of this number, from 0. False: there were not so many.
  bool CutAt(int change) const {
    int left = change;
    const auto done = FinishRestore(data_, [&]() -> Result<void> {
      if (left-- > 0) return {};
      return Fail(std::errc::operation_canceled, "go on without power");
    });
    return !done && done.error().cause == std::errc::operation_canceled;
  }
  void PutBack() const { fs::rename(data_ / kKept, data_ / kNext); }

  const std::string old_ = std::string(64, 'a'), new_ = std::string(64, 'b');
  // In memory: a restore waits for the disk at each step, and the cuts are many.
  const fs::path folder_ = (fs::exists("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) /
                           ("restore-test-" + std::to_string(::getpid()));
  const fs::path data_ = folder_;
};

TEST_F(RestoreTest, PutsTakesAwayAndChoosesAndLeavesTheRest) {
  EXPECT_TRUE(FinishRestore(data_).value());
  EXPECT_EQ(Look(), (Box{{"chosen", new_},
                         {"own/02-same.toml", "stays"},
                         {"own/03-new.toml", "new own/03-new.toml"},
                         {"pack a", "there"},
                         {"pack b", "there"},
                         {"settings/box.toml", "new settings/box.toml"},
                         {"settings/keys/company.pub", "new settings/keys/company.pub"}}));
  EXPECT_EQ(ReadFile(data_ / "machine-id").value(), "0123");
  EXPECT_EQ(store::ReadChoice(data_ / "shows").previous, old_);
  EXPECT_FALSE(fs::exists(data_ / kNext));
  EXPECT_FALSE(FinishRestore(data_).value()) << "it is done once";
}

TEST_F(RestoreTest, CanBeUndoneAndThatToo) {
  const Box before = Look();
  ASSERT_TRUE(FinishRestore(data_).value());
  const Box after = Look();
  PutBack();
  ASSERT_TRUE(FinishRestore(data_).value());
  EXPECT_EQ(Look(), before);
  PutBack();
  ASSERT_TRUE(FinishRestore(data_).value());
  EXPECT_EQ(Look(), after);
}

// Before each change of the disk, every removal of a file among them; after each of these cuts once without another one, and
// with a second one at some changes of the start after it.
TEST_F(RestoreTest, IsTheSameWhereverThePowerGoes) {
  const Box before = Look();
  int changes = 0, cuts = 0;
  ASSERT_TRUE(FinishRestore(data_, [&]() -> Result<void> { return ++changes, Result<void>(); }).value());
  const Box after = Look();
  const auto goes_on = [&](const std::string& where) {
    ++cuts;
    ASSERT_TRUE(FinishRestore(data_)) << where;
    ASSERT_EQ(Look(), after) << where;
    PutBack();
    ASSERT_TRUE(FinishRestore(data_).value()) << where;
    ASSERT_EQ(Look(), before) << "the way back, " << where;
  };
  for (int first = 0; first < changes && !HasFatalFailure(); ++first) {
    const std::string where = "cut at " + std::to_string(first);
    Renew();
    ASSERT_TRUE(CutAt(first)) << where;
    goes_on(where);
    for (int second = first % 4; Renew(), CutAt(first), CutAt(second); second += 4)
      goes_on(where + ", then at " + std::to_string(second));
  }
  EXPECT_GE(changes, 25);
  EXPECT_GE(cuts, 60);
}

// The last of a restore is that the older way back goes: nothing else may hang on it.
TEST_F(RestoreTest, KeepsOneWayBackAndNoLeftovers) {
  ASSERT_TRUE(FinishRestore(data_).value());
  EXPECT_FALSE(fs::exists(data_ / kKept / kFiles / "own/04-older.toml"));
  EXPECT_TRUE(fs::exists(data_ / kKept / kFiles / "own/01-old.toml"));
  for (const char* gone : {kNext, kKeeping, kIncoming, kDropped})
    EXPECT_FALSE(fs::exists(data_ / gone)) << gone;
}

TEST_F(RestoreTest, OfATornPlanChangesNothing) {
  const Box before = Look();
  std::string text = ReadFile(data_ / kNext / kPlan).value();
  Put(std::string(kNext) + "/plan", text.substr(0, text.size() / 2));
  EXPECT_EQ(FinishRestore(data_).error().cause, std::errc::bad_message);
  EXPECT_EQ(Look(), before);
}

TEST(RestorePlanTest, NamesNothingOutsideOfABoxsFolders) {
  for (const char* path : {"settings/../machine-id", "machine-id", "/etc/passwd", "own/../lips/x.toml",
                           "own/.hidden.toml", "own/log/report", "settings/box.last-good.toml",
                           "shows/choice.0", "own/a\\b.toml", "settings/keys/x.key", ""}) {
    EXPECT_FALSE(IsRestored(path) || IsPack(path)) << path;
    EXPECT_FALSE(ParsePlan(Format({"", {path}, {}}))) << path;
    EXPECT_FALSE(ParsePlan(Format({"", {}, {path}}))) << path;
  }
  const Plan sound{std::string(64, 'c'), {"own/01-a b.toml"}, {"lips/lips.settings"}};
  EXPECT_EQ(ParsePlan(Format(sound)), sound);
}

}  // namespace
}  // namespace kaori::restore
