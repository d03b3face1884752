// The lines to a machine: the agent's answers on a noisy one, answers that come too late, and QEMU's monitor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "hw-sim/hil/machine_lines.h"
#include "hw-sim/hil/qmp.h"
#include "hw-sim/hil/serial_agent.h"
#include "tests/hil/agent/serial_line.h"
#include "tests/hw-sim/machine_end.h"

namespace kaori::hil {
namespace {

TEST(ParseAnswer, WaitsForAllOfIt) {
  std::string waiting = "\x02OK 7 5\nhel";
  EXPECT_FALSE(ParseAnswer(waiting));
  waiting += "lo\x02";
  const auto answer = ParseAnswer(waiting);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->yes);
  EXPECT_EQ(answer->number, 7U);
  EXPECT_EQ(answer->text, "hello");
  EXPECT_EQ(waiting, "\x02") << "the next one has begun";
}

TEST(ParseAnswer, LeavesTheNoiseOfTheLine) {
  std::string waiting = "[  1.2] a word of the kernel\r\n\x02NO 1 3\nwhy";
  const auto answer = ParseAnswer(waiting);
  ASSERT_TRUE(answer);
  EXPECT_FALSE(answer->yes);
  EXPECT_EQ(answer->text, "why");
}

TEST(ParseAnswer, PassesOverAHeadThatIsTorn) {
  for (const char* torn : {"OK 1 1x\n", "OK 1\n", "OK 1 \n", "OK x 1\n", "O\n", "\n", "OK 1 -1\n"}) {
    std::string waiting = std::string("\x02") + torn + "\x02OK 1 2\nhi";
    const auto answer = ParseAnswer(waiting);
    ASSERT_TRUE(answer) << torn;
    EXPECT_EQ(answer->text, "hi") << torn;
  }
}

TEST(ParseQuestion, IsTheOtherEndOfTheLine) {
  const auto question = agent::ParseQuestion("12 read /etc/fstab");
  ASSERT_TRUE(question);
  EXPECT_EQ(question->number, 12U);
  EXPECT_EQ(question->text, "read /etc/fstab");
  for (const char* torn : {"", "hello", " hello", "12", "x 12", "-1 hello"})
    EXPECT_FALSE(agent::ParseQuestion(torn)) << torn;
  std::string bytes = agent::AnswerTo(12, std::string("two\nlines"));
  const auto answer = ParseAnswer(bytes);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->number, 12U);
  EXPECT_EQ(answer->text, "two\nlines");
  EXPECT_TRUE(bytes.empty());
}

class Agent : public ::testing::Test {
 protected:
  Agent() {
    const auto found = driver_.Find(std::chrono::seconds(9));
    EXPECT_TRUE(found) << found.error().message();
  }
  Result<std::string> Ask(const std::string& question) {
    return driver_.Ask(question, std::chrono::seconds(9));
  }

  std::size_t holds_ = 0;  // How many questions that were heard wait for their answers on purpose.
  std::vector<agent::Question> heard_;
  MachineEnd machine_{[this](const std::string& line) {
    std::string answers;
    if (auto question = agent::ParseQuestion(line)) heard_.push_back(std::move(*question));
    for (; heard_.size() > holds_; heard_.erase(heard_.begin()))
      answers += agent::AnswerTo(heard_.front().number, "to " + heard_.front().text);
    return answers;
  }};
  SerialAgentDriver driver_{machine_.path(), machine_};
};

TEST_F(Agent, IsNotTakenAtTheWordOfAnAnswerThatComesTooLate) {
  EXPECT_EQ(Ask("clock"), "to clock");
  holds_ = 2;
  for (const char* slow : {"board", "usb"}) EXPECT_EQ(Ask(slow).error().cause, std::errc::timed_out);
  holds_ = 0;
  EXPECT_EQ(Ask("levels"), "to levels") << "the answers to the others come first";
  EXPECT_EQ(Ask("edges"), "to edges");
}

TEST_F(Agent, ThatCannotWorkSaysSoUnasked) {
  holds_ = 1;
  machine_.Say(agent::AnswerTo(0, FailInput("the root is not there")));
  const auto answer = Ask("board");
  ASSERT_FALSE(answer);
  EXPECT_THAT(answer.error().message(), ::testing::HasSubstr("the root is not there"));
  EXPECT_EQ(answer.error().kind, ErrorKind::kSystem) << "no control has found anything wrong by it";
}

// A monitor that agrees to all it is told, once it has said something else.
class Monitor : public ::testing::Test {
 protected:
  std::vector<std::string> heard_;
  MachineEnd machine_{[this](const std::string& line) {
                        heard_.push_back(line);
                        return R"({"event": "RESET"})"
                               "\n" +
                               answer_ + "\n";
                      },
                      "{\"QMP\": {}}\n"};
  std::string answer_ = R"({"return": {}})";
};

TEST_F(Monitor, IsToldNamesAsTheyAre) {
  auto qmp = Qmp::Call(machine_.path(), machine_);
  ASSERT_TRUE(qmp) << qmp.error().message();
  ASSERT_TRUE(qmp->Do("screendump", {{"filename", "/tmp/the \"first\" \\ face.png"}, {"head", 1}}));
  EXPECT_THAT(
      heard_,
      ::testing::ElementsAre(
          R"({"execute":"qmp_capabilities","arguments":{}})",
          R"({"execute":"screendump","arguments":{"filename":"/tmp/the \"first\" \\ face.png","head":1}})"));
}

TEST_F(Monitor, SaysWhatItRefuses) {
  auto qmp = Qmp::Call(machine_.path(), machine_);
  ASSERT_TRUE(qmp);
  answer_ = R"({"error": {"class": "GenericError", "desc": "no such head"}})";
  const auto refused = qmp->Do("screendump");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), ::testing::HasSubstr("screendump: no such head"));
  EXPECT_EQ(refused.error().kind, ErrorKind::kSystem) << "no control has found anything wrong by it";
}

TEST_F(Monitor, FindsAPartOfTheMachineByItsType) {
  auto qmp = Qmp::Call(machine_.path(), machine_);
  ASSERT_TRUE(qmp);
  answer_ =
      R"({"return": [{"name": "realized", "type": "bool"}, {"name": "device[6]", "type": "child<pl061>"}]})";
  EXPECT_EQ(qmp->ChildOfType("/machine/unattached", "pl061"), "/machine/unattached/device[6]");
  EXPECT_EQ(qmp->ChildOfType("/machine/unattached", "pl06").error().cause, std::errc::no_such_device);
}

// QEMU's test protocol beside its monitor; what it says is the test's.
class Lines : public Monitor {
 protected:
  Lines() {
    answer_ = R"({"return": [{"name": "device[6]", "type": "child<pl061>"}]})";
    auto qmp = Qmp::Call(machine_.path(), machine_);
    if (qmp) lines_ = MachineLines::Open(protocol_.path(), *qmp, protocol_);
    EXPECT_TRUE(lines_);
  }
  std::string says_ = "OK\n";
  MachineEnd protocol_{[this](const std::string& line) {
    told_ = line;
    return says_;
  }};
  std::string told_;
  Result<MachineLines> lines_ = FailInput("not called yet");
};

TEST_F(Lines, AreSetAtTheControllerThatTheMachineHas) {
  EXPECT_TRUE(lines_->Set(4, true));
  EXPECT_EQ(told_, "set_irq_in /machine/unattached/device[6] unnamed-gpio-in 4 1");
  EXPECT_TRUE(lines_->Set(0, false));
  EXPECT_EQ(told_, "set_irq_in /machine/unattached/device[6] unnamed-gpio-in 0 0");
}

TEST_F(Lines, SayWhatTheMachineRefuses) {
  says_ = "FAIL Unknown device\n";
  const auto refused = lines_->Set(9, true);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), ::testing::HasSubstr("FAIL Unknown device"));
  EXPECT_EQ(refused.error().kind, ErrorKind::kSystem) << "no control has found anything wrong by it";
}

}  // namespace
}  // namespace kaori::hil
