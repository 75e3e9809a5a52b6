// What the XML library must not be given, however it is hidden.
#include "runtime/host/xml_text.h"

#include <gtest/gtest.h>

#include "base/limits.h"

namespace oncard::runtime {
namespace {

std::string Times(size_t count, const std::string& text) {
  std::string all;
  for (size_t i = 0; i < count; ++i) all += text;
  return all;
}

TEST(XmlText, ElementsAreNestedUpToALimit) {
  const std::string deep = Times(kXmlDepthMax, "<a>") + Times(kXmlDepthMax, "</a>");
  EXPECT_FALSE(CheckXml(deep + deep));
  const auto refusal = CheckXml("<b>" + deep + "</b>");
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->offset, 3 * kXmlDepthMax);
  EXPECT_EQ(refusal->why.en, "elements are nested at most 64 deep");
}

/// Each opens an element once more than it closes one, if it is read as the library reads it.
TEST(XmlText, NothingHidesADepth) {
  for (const std::string opens :
       {"<a b='/>'>", "<a b = \"</a>\">", "<a'>", "<a\">", "<a b'='x'>", "<<a>", "<a=/='>'>",
        "<a><!--></a>-->", "<a><!--</a>-->", "<a><![CDATA[</a>]]>", "<a><?</a>?>", "<a><?></a>?>",
        "<a><!x[>", "<a><!DOCTYPE a [</a>]>", "<a><!DOCTYPE ]a[</a>]>", "<a><!DOCTYPE[>",
        "<a><!DOCTYPEa[>", "<a><b/>", "<a>/>"}) {
    EXPECT_TRUE(CheckXml(Times(kXmlDepthMax + 1, opens))) << opens;
  }
}

TEST(XmlText, WhatIsOpenedAndClosedIsNotDeep) {
  for (const std::string closed :
       {"<a></a>", "<a/>", "<a b='>'/>", "<a b=\"'\" c='x'></a >", "<!-- <a> -->",
        "<![CDATA[<a>]]>", "<?a <b>?>", "<!DOCTYPE a [<!ELEMENT a (b)>]>", "<a\n/>", "x > y "}) {
    EXPECT_FALSE(CheckXml("<a>" + Times(2 * kXmlDepthMax, closed) + "</a>")) << closed;
  }
}

TEST(XmlText, ANulIsRefused) {
  const auto refusal = CheckXml(std::string_view("<a/>\0<b/>", 9));
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->offset, 4u);
}

TEST(XmlText, Utf16BecomesUtf8) {
  constexpr std::string_view kText = "<a/>\u00E9\u8F74\uFFFD\uFFFD";
  const std::u16string wide = u"\uFEFF<a/>\u00E9\u8F74\U0001F600";
  std::string little;
  std::string big;
  for (const char16_t unit : wide) {
    const char low = static_cast<char>(unit & 0xFF);
    const char high = static_cast<char>(unit >> 8);
    little += {low, high};
    big += {high, low};
  }
  EXPECT_TRUE(IsUtf16(little));
  EXPECT_TRUE(IsUtf16(big));
  EXPECT_FALSE(IsUtf16(kText));
  EXPECT_EQ(Utf8Of(little), kText);
  EXPECT_EQ(Utf8Of(big), kText);
  EXPECT_EQ(Utf8Of(little + "x"), kText);
}

}  // namespace
}  // namespace oncard::runtime
