// The reader for files that a person names.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "drivers/base/packet_socket.h"
#include "drivers/base/read_file.h"

namespace kaori {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class FileReader : public ::testing::Test {
 protected:
  FileReader() : folder_(fs::path(::testing::TempDir()) / ("read-file-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~FileReader() override { fs::remove_all(folder_); }

  fs::path Write(const std::string& text) const {
    std::ofstream(folder_ / "file", std::ios::binary) << text;
    return folder_ / "file";
  }
  fs::path folder_;
};

TEST_F(FileReader, ReadsAWholeFileWithEveryByte) {
  std::string bytes(200'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 7 >> 3U);
  EXPECT_EQ(*ReadFile(Write(bytes)), bytes);
  EXPECT_EQ(*ReadFile(Write("")), "");
  EXPECT_EQ(*ReadFile(Write("12345"), {.most_bytes = 5}), "12345");
}

TEST_F(FileReader, ReadsFilesThatDoNotSayTheirSize) {
  EXPECT_THAT(*ReadFile("/proc/self/status"), HasSubstr("VmRSS"));
  EXPECT_THAT(ReadFile("/proc/self/status", {.most_bytes = 10}).error().message(),
              "read /proc/self/status: it is larger than 10 bytes");
}

TEST_F(FileReader, NamesTheFileAndTheReasonInOneLine) {
  const auto message = [](const fs::path& file) { return ReadFile(file).error().message(); };
  EXPECT_EQ(message(folder_ / "none"), "read " + (folder_ / "none").string() + ": No such file or directory");
  EXPECT_EQ(message(folder_), "read " + folder_.string() + ": Is a directory");
  EXPECT_EQ(message("/dev/zero"), "read /dev/zero: it is a device, not a file");
  const auto socket = ListenForPackets((folder_ / "socket").string());
  ASSERT_TRUE(socket);
  EXPECT_THAT(message(folder_ / "socket"), HasSubstr("No such device or address"));
}

TEST_F(FileReader, DoesNotWaitForAPipeThatNobodyWrites) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  ::alarm(5);  // It would wait for ever.
  EXPECT_EQ(ReadFile(pipe).error().message(), "read " + pipe.string() + ": it is a pipe, not a file");
  ::alarm(0);
}

TEST_F(FileReader, OpensARegularFileForWhoeverReadsItInPieces) {
  const auto file = OpenRegular(Write("12345"), "open it");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->bytes, 5U);
  char first = 0;
  EXPECT_EQ(::read(file->fd.get(), &first, 1), 1);
  EXPECT_EQ(first, '1');
}

TEST_F(FileReader, FollowsALinkUnlessTheCallerRefusesThem) {
  fs::create_symlink(Write("12345"), folder_ / "link");
  EXPECT_TRUE(OpenRegular(folder_ / "link", "open it"));
  const auto refused = OpenRegular(folder_ / "link", "open it", Links::kRefuse);
  EXPECT_EQ(refused.error().cause, std::errc::too_many_symbolic_link_levels);
  EXPECT_FALSE(IsNoFile(refused.error()));
}

TEST_F(FileReader, KnowsAnOpenedPipeAndAnOpenedFolderForNoFile) {
  const auto of = [](const char* name, int flags) {
    return RequireRegular(UniqueFd(::open(name, flags | O_CLOEXEC)), "look at it").error();
  };
  EXPECT_EQ(of("/dev/zero", O_RDONLY).message(), "look at it: it is a device, not a file");
  EXPECT_TRUE(IsNoFile(of("/dev/zero", O_RDONLY)));
  EXPECT_TRUE(IsNoFile(of("/tmp", O_RDONLY | O_DIRECTORY)));
}

TEST_F(FileReader, DoesNotTouchAFileThatIsTooLarge) {
  const fs::path file = Write("");
  ASSERT_EQ(::truncate(file.c_str(), off_t{1} << 40U), 0);
  const auto refused = ReadFile(file);
  EXPECT_EQ(refused.error().message(), "read " + file.string() + ": it is larger than 16 MiB");
  EXPECT_EQ(refused.error().cause, std::errc::file_too_large);
}

TEST_F(FileReader, RefusesWhatIsNestedTooDeepAndNamesTheLine) {
  const auto depth = [&](const std::string& text) {
    const auto read = ReadFile(Write(text), {.most_levels = 3});
    return read ? "" : read.error().message().substr(folder_.string().size());
  };
  const std::string refused = "is nested deeper than 3 levels";
  for (const char* deep :
       {"[a.a.a.a]", "a.b.c.d.e = 1", "[[[[1]]]]", "{\"a\":{\"b\":{\"c\":{}}}}", "a = [[{b.c = 1}]]"})
    EXPECT_EQ(depth(deep), "/file:1: " + refused) << deep;
  EXPECT_EQ(depth("# [[[[\na = '[[[['\nb = \"\\\"[[[[\"\nc = \"\"\"\n[[[[\"\"\"\n[[[[1]]]]"),
            "/file:6: " + refused);
  for (const char* flat :
       {"", "[a.a.a]", "a.b.c.d = 1", "[a.b]\nc.d = [1.5, 2.5, 3.5]\n", "[[a]]\n[[a]]\n[[a]]\n[[a]]\n",
        "]]]][[[1]]]", "{\"a\": \"{{{{{\", \"b\": [1, 2]}", "a = \"", "a = '''", "a = \"\\"})
    EXPECT_EQ(depth(flat), "") << flat;
}

}  // namespace
}  // namespace kaori
