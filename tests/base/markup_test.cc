#include "base/markup.h"

#include <gtest/gtest.h>

namespace oncard {
namespace {

TEST(EscapeMarkup, ReplacesWhatMeansSomething) {
  EXPECT_EQ(EscapeMarkup("a < b && c > \"d\""), "a &lt; b &amp;&amp; c &gt; &quot;d&quot;");
  EXPECT_EQ(EscapeMarkup("线程 0"), "线程 0");
  EXPECT_EQ(EscapeMarkup(""), "");
}

TEST(EscapeTableCell, KeepsBarsInTheCell) { EXPECT_EQ(EscapeTableCell("a|b | c"), "a\\|b \\| c"); }

}  // namespace
}  // namespace oncard
