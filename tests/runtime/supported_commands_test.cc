// Every command of the catalogue is executed by the card, answered by the host library, or has a
// reason why not.
#include <gtest/gtest.h>

#include "gtcalls/gts/family.h"
#include "runtime/host/host_services.h"

namespace oncard::runtime {
namespace {

TEST(SupportedCommandsTest, WhatIsNotExecutedHasAReason) {
  for (const gtcalls::Command& command : gtcalls::GtsFamily().catalogue.commands()) {
    if (gtcalls::GtsFamily().Executes(command) || FindHostService(command) != nullptr) continue;
    const Message* why = gtcalls::GtsFamily().why_unsupported(command);
    ASSERT_NE(why, nullptr) << command.name << " needs a row in gtcalls/gts/unsupported.def";
    EXPECT_FALSE(why->en.empty()) << command.name;
    EXPECT_FALSE(why->zh.empty()) << command.name;
  }
}

TEST(SupportedCommandsTest, ReasonsNameCommandsOfTheCatalogue) {
#define UNSUPPORTED(name, id) \
  EXPECT_NE(gtcalls::GtsFamily().catalogue.Find(#name), nullptr) << #name;
#include "gtcalls/gts/unsupported.def"
}

}  // namespace
}  // namespace oncard::runtime
