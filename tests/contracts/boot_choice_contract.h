// The contract of ports::BootChoice.
#pragma once

#include <gtest/gtest.h>

#include "drivers/ports/boot_choice.h"
#include "tests/contracts/contract.h"

namespace kaori::contracts {

// A machine that was started from slot A, its default.
class BootChoiceSubject : public AnySubject {
 public:
  virtual ports::BootChoice& choice() = 0;
  // Starts it again, as TryOnce wants it: by a restart, or by its switch. `choice` is another one afterwards.
  virtual void SwitchOn() = 0;
  // The firmware keeps nothing any more.
  virtual void ForgetVariables() = 0;
};

class BootChoiceContract : public Contract<BootChoiceSubject> {
 protected:
  ports::BootChoice& choice() { return subject_->choice(); }
  // The slots that the next starts take, as "AB".
  std::string Starts(int count) {
    std::string slots;
    for (int n = 0; n < count; ++n) {
      subject_->SwitchOn();
      slots += choice().running() == ports::Slot::kA ? 'A' : 'B';
    }
    return slots;
  }
};

TEST_P(BootChoiceContract, StartsItsDefaultAgainAndAgain) {
  EXPECT_EQ(*choice().Default(), ports::Slot::kA);
  EXPECT_EQ(Starts(3), "AAA");
  EXPECT_FALSE(*ports::IsTrial(choice()));
}

TEST_P(BootChoiceContract, TriesASlotOnceAndThenStartsItsDefaultAgain) {
  ASSERT_TRUE(choice().TryOnce(ports::Slot::kB));
  EXPECT_EQ(choice().running(), ports::Slot::kA) << "only the next start is another one";
  EXPECT_EQ(Starts(1), "B");
  EXPECT_TRUE(*ports::IsTrial(choice()));
  EXPECT_EQ(*choice().Default(), ports::Slot::kA);
  EXPECT_EQ(Starts(2), "AA");
}

TEST_P(BootChoiceContract, AConfirmedSlotStartsFromThenOn) {
  ASSERT_TRUE(choice().TryOnce(ports::Slot::kB));
  EXPECT_EQ(Starts(1), "B");
  ASSERT_TRUE(choice().Confirm(ports::Slot::kB));
  EXPECT_FALSE(*ports::IsTrial(choice()));
  EXPECT_EQ(Starts(2), "BB");
  ASSERT_TRUE(choice().TryOnce(ports::Slot::kA));
  EXPECT_EQ(Starts(2), "AB") << "the other way round as well";
}

TEST_P(BootChoiceContract, ConfirmingTheDefaultChangesNothing) {
  ASSERT_TRUE(choice().Confirm(ports::Slot::kA));
  EXPECT_EQ(Starts(2), "AA");
}

TEST_P(BootChoiceContract, TheLastWordBeforeAStartCounts) {
  ASSERT_TRUE(choice().TryOnce(ports::Slot::kB));
  ASSERT_TRUE(choice().TryOnce(ports::Slot::kA));
  EXPECT_EQ(Starts(2), "AA");
}

TEST_P(BootChoiceContract, SaysThatAMachineForgetsWhichThenStartsItsDefault) {
  subject_->ForgetVariables();
  EXPECT_EQ(Cause(choice().TryOnce(ports::Slot::kB)), std::errc::not_supported);
  EXPECT_EQ(Starts(1), "A");
}

}  // namespace kaori::contracts
