// Every command of the catalogue is executed by the card, answered by the host library, or has a
// reason why it is not supported.
#include <gtest/gtest.h>

#include "gtcalls/gts/family.h"
#include "runtime/host/services.h"

namespace oncard::runtime {
namespace {

const gtcalls::Family& kFamily = gtcalls::GtsFamily();

TEST(SupportedCommandsTest, WhatIsNotExecutedHasAReason) {
  for (const gtcalls::Command& command : kFamily.catalogue.commands()) {
    const int executed = kFamily.Executes(command) ? 1 : 0;
    const int answered = FindHostService(command) != nullptr ? 1 : 0;
    const Message* why = kFamily.why_unsupported(command);
    EXPECT_EQ(executed + answered + (why != nullptr ? 1 : 0), 1)
        << command.name << " needs a function, a service of the host library, or a row in "
        << "gtcalls/gts/unsupported.def, and only one of them";
    if (why == nullptr) continue;
    EXPECT_FALSE(why->en.empty()) << command.name;
    EXPECT_FALSE(why->zh.empty()) << command.name;
  }
}

TEST(SupportedCommandsTest, ReasonsNameCommandsOfTheCatalogue) {
#define UNSUPPORTED(name, id) EXPECT_NE(kFamily.catalogue.Find(#name), nullptr) << #name;
#include "gtcalls/gts/unsupported.def"
}

}  // namespace
}  // namespace oncard::runtime
