// Every return code that the documentation names can be explained.
#include "gtcalls/gts/return_codes.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

#include "base/files.h"
#include "base/limits.h"

namespace oncard::gtcalls::gts {
namespace {

// The numbers in the first column of the tables of a page, in the section with a title.
std::set<int> CodesIn(const std::string& page, const std::string& title) {
  const auto text = ReadFile(std::string(ONCARD_SOURCE_DIR) + "/docs/" + page, kOwnKind);
  EXPECT_TRUE(text.ok()) << page;
  if (!text.ok()) return {};
  std::string section = text.value().substr(text.value().find("## " + title));
  section = section.substr(0, section.find("\n## ", 1));
  static const std::regex kRow("\n\\| ([-0-9, ]+) \\|");
  static const std::regex kNumber("-?[0-9]+");
  std::set<int> codes;
  for (std::sregex_iterator row(section.begin(), section.end(), kRow), end; row != end; ++row) {
    const std::string cell = (*row)[1].str();
    for (std::sregex_iterator i(cell.begin(), cell.end(), kNumber); i != end; ++i) {
      codes.insert(std::stoi(i->str()));
    }
  }
  return codes;
}

TEST(ReturnCodes, OfTheDocumentationHaveAPage) {
  const std::set<int> host = CodesIn("host-api.md", "Return codes");
  EXPECT_TRUE(host.contains(7) && host.contains(-10) && host.contains(2008));
  const std::set<int> ahead = CodesIn("look-ahead.md", "Codes");
  EXPECT_TRUE(ahead.contains(1) && ahead.contains(110));
  for (const std::set<int>& codes : {host, ahead}) {
    for (const int code : codes) EXPECT_TRUE(ReturnCodePage(code).has_value()) << code;
  }
}

// GTS manual table 3-1.
TEST(ReturnCodes, OfTheManualHaveAPage) {
  for (const int code : {0, 1, 7, -1, -6, -7}) EXPECT_TRUE(ReturnCodePage(code)) << code;
  for (const int code : {2, 27, -2, 99, 2009}) EXPECT_FALSE(ReturnCodePage(code)) << code;
}

TEST(ReturnCodes, NameTheVariablesThatGtOpenReads) {
  const std::optional<Message> page = ReturnCodePage(-6);
  ASSERT_TRUE(page.has_value());
  for (const char* what : {"ONCARD_CLOCK", "ONCARD_CARD", "ONCARD_MRAM"}) {
    EXPECT_NE(page->en.find(what), std::string::npos) << what;
    EXPECT_NE(page->zh.find(what), std::string::npos) << what;
  }
}

TEST(ReturnCodes, SayWhyAProgramIsNotCompiled) {
  const std::optional<Message> page = ReturnCodePage(1);
  ASSERT_TRUE(page.has_value());
  EXPECT_TRUE(page->en.ends_with(
      "\n\n"
      "GT_Compile\n"
      "    the program has errors, or .bin and .ini cannot be written\n"
      "    look at pMessage and pLineNo of TCompileInfo, or use 'oncard check'\n"));
  EXPECT_TRUE(
      page->zh.ends_with("\n\n"
                         "GT_Compile\n"
                         "    程序有错误，或无法写入 .bin 和 .ini\n"
                         "    请查看 TCompileInfo 的 pMessage 和 pLineNo，或使用“oncard check”\n"));
}

TEST(ReturnCodes, HaveEachMeaningInBothLanguages) {
  const std::optional<Message> page = ReturnCodePage(2008);
  ASSERT_TRUE(page.has_value());
  EXPECT_EQ(page->en,
            "return code 2008\n"
            "\n"
            "GT_Download\n"
            "    a file is damaged, or .bin and .ini do not belong together\n"
            "    compile the program again, and keep both files in one folder\n"
            "\n"
            "GT_GetFunId, GT_GetVarId\n"
            "    there is no such name\n"
            "    check the spelling, and whether a local belongs to the function\n");
  EXPECT_EQ(page->zh,
            "返回值 2008\n"
            "\n"
            "GT_Download\n"
            "    文件损坏，或 .bin 与 .ini 不是一对\n"
            "    请重新编译，并把两个文件放在同一目录\n"
            "\n"
            "GT_GetFunId、GT_GetVarId\n"
            "    没有该名称\n"
            "    请检查拼写，以及局部变量是否属于该函数\n");
}

}  // namespace
}  // namespace oncard::gtcalls::gts
