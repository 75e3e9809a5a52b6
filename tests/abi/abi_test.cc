// Hosts that were linked with an earlier libgts run with this one: its interface is the one of
// libgts.abi, which ./x abi writes.
#include <gtest/gtest.h>

#include <string>

#include "base/files.h"
#include "tests/tools/process.h"

namespace oncard::abi {
namespace {

using tools::ProcessResult;
using tools::RunProgram;
using tools::ScratchFolder;

const std::string kInterface = ONCARD_SOURCE_DIR "/tests/abi/libgts.abi";

constexpr const char* kAdvice =
    "the interface of libgts is no longer that of tests/abi/libgts.abi. If functions were only "
    "added, run ./x abi. If others were changed or taken away, linked hosts no longer run: give "
    "the libraries another version, too (ONCARD_SOVERSION in cmake/OncardFamilies.cmake)\n";

class InterfaceOfLibgts : public testing::Test {
 protected:
  void SetUp() override {
    if (RunProgram({"sh", "-c", "command -v abidiff"}).exit_code != 0) {
      GTEST_SKIP() << "abidiff is not installed (abigail-tools)";
    }
  }
};

TEST_F(InterfaceOfLibgts, IsTheOneOfItsVersion) {
  const ProcessResult result =
      RunProgram({"abidiff", kInterface, ONCARD_GTS_WITH_DEBUG_INFORMATION});
  EXPECT_EQ(result.exit_code, 0) << kAdvice << result.out << result.err;
}

// The library that hosts load has no debug information; its functions are compared by their names.
TEST_F(InterfaceOfLibgts, IsTheOneOfTheLibraryThatHostsLoad) {
  const ProcessResult result = RunProgram({"abidiff", kInterface, ONCARD_GTS});
  EXPECT_EQ(result.exit_code, 0) << kAdvice << result.out << result.err;
}

// The attribute of a line of XML.
std::string Attribute(const std::string& line, const std::string& name) {
  const size_t begin = line.find(' ' + name + "='") + name.size() + 3;
  return line.substr(begin, line.find('\'', begin) - begin);
}

TEST_F(InterfaceOfLibgts, IsAnotherOneWithAnotherParameter) {
  std::string interface = ReadFile(kInterface).value();
  const size_t type = interface.find("<type-decl name='double'");
  ASSERT_NE(type, std::string::npos);
  const std::string of_double = Attribute(interface.substr(type), "id");
  const size_t function = interface.find("<function-decl name='GT_AxisOn'");
  ASSERT_NE(function, std::string::npos);
  const std::string parameter = "<parameter type-id='";
  const size_t axis = interface.find(parameter, function) + parameter.size();
  interface.replace(axis, interface.find('\'', axis) - axis, of_double);
  const ScratchFolder folder;
  const ProcessResult result = RunProgram(
      {"abidiff", folder.Write("changed.abi", interface), ONCARD_GTS_WITH_DEBUG_INFORMATION});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_NE(result.out.find("1 Changed"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace oncard::abi
