// Hosts written for GT400 cards, from their headers to their output under `oncard exec`.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

const std::string kFolder = ONCARD_GT400_FOLDER;

ProcessResult Exec(const std::string& host) {
  return RunOncard({"exec", "--", kFolder + "/" + host});
}

// --- Headers -------------------------------------------------------------------------------------

// The manual: 4 + 4 * kinds + 16 * commands.
TEST(Gt400BackgroundSet, HasTheLayoutOfTheManual) {
  const ProcessResult host = Exec("gt400_background");
  EXPECT_EQ(host.exit_code, 0) << host.err;
  EXPECT_EQ(host.out,
            "02 00 00 00 01 00 02 00 41 00 01 00 02 00 00 00\n"
            "01 02 03 04 00 00 00 00 16 00 01 00 02 00 00 00\n"
            "00 00 00 00 00 00 00 00 20 00 01 00 4C 00 01 00\n"
            "02 00 FF FF 00 00 00 00 14 00 00 00\n"
            "1\n");
}

}  // namespace
}  // namespace oncard::tools
