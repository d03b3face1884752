// The command line of kaori-atelier: what makes no sense is said in one line, and nothing is done.
#include <gmock/gmock.h>

#include "appliance/authoring/pack/facts.h"
#include "appliance/authoring/pack/verbs.h"
#include "appliance/core/show/pack.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using authoring::Arguments;
using authoring::Verb;
using ::testing::HasSubstr;

Result<Arguments> Parse(const Verb& verb, std::vector<std::string> words) {
  std::vector<char*> args;
  for (std::string& word : words) args.push_back(word.data());
  return ParseArguments(verb, args);
}

TEST(AtelierVerbs, TakeWordsAndOptionsInAnyOrder) {
  const auto arguments = Parse(authoring::PackVerb(), {"--sign", "company.key", "folder", "file.kaori"});
  ASSERT_TRUE(arguments);
  EXPECT_THAT(arguments->words, ::testing::ElementsAre("folder", "file.kaori"));
  EXPECT_EQ(arguments->options.at("--sign"), "company.key");
}

TEST(AtelierVerbs, SayWhatIsMissingTooMuchOrUnknown) {
  const Verb pack = authoring::PackVerb();
  EXPECT_EQ(Parse(pack, {"folder"}).error().message(), "FILE is missing");
  EXPECT_EQ(Parse(pack, {"a", "b", "c"}).error().message(), "\"c\" is one word too many");
  EXPECT_EQ(Parse(pack, {"a", "b", "--seal"}).error().message(), "there is no option --seal");
  EXPECT_EQ(Parse(pack, {"a", "b", "--sign"}).error().message(), "--sign wants a KEYFILE");
}

TEST(AtelierVerbs, EndWithTwoWhereTheCommandLineMakesNoSense) {
  const std::vector<Verb> verbs{authoring::KeygenVerb(), authoring::InfoVerb()};
  std::string wrong = "kegyen";
  std::string right = "keygen";
  std::string help = "--help";
  std::vector<char*> args{wrong.data()};
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Dispatch(verbs, args), 2);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "kaori-atelier: there is no verb \"kegyen\"; kaori-atelier --help lists them\n");
  args = {right.data(), help.data()};
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(Dispatch(verbs, args), 0);
  EXPECT_THAT(::testing::internal::GetCapturedStdout(),
              HasSubstr("kaori-atelier keygen KEYFILE: make a key"));
}

using AtelierInfo = PackTest;

TEST_F(AtelierInfo, NamesAllThatAProgramAsksFor) {
  const auto file = Write(show::EncodePack(SmallShow()));
  const auto facts = authoring::GatherFacts(file, [](const std::string&) {});
  ASSERT_TRUE(facts) << facts.error().message();
  const std::string json = FactsJson(*facts);
  for (const char* name : {"triangles_on_face", "faces", "expressions", "mouth_shapes", "control_points",
                           "folds", "lid_gaps", "teeth_through_lips", "load_ms"})
    EXPECT_THAT(json, HasSubstr('"' + std::string(name) + "\":")) << name;
  EXPECT_THAT(json, HasSubstr("\"faces\": 4,"));
  EXPECT_THAT(json, HasSubstr("\"expressions\": 3,"));
  EXPECT_THAT(json, HasSubstr("\"mouth_shapes\": 2,"));
  EXPECT_THAT(FactsPage(*facts), HasSubstr("not signed"));
  EXPECT_GT(facts->load_ms, 0);
}

}  // namespace
}  // namespace kaori::tests
