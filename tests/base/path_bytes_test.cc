#include "base/path_bytes.h"

#include <gtest/gtest.h>

namespace oncard {
namespace {

TEST(PathBytes, ANameKeepsItsBytes) {
  for (const std::string name :
       {"", "a.c", "a/b.c", "/a//b/", "程序/轴 1.c", "\xB3\xCC.c", "a\\b"}) {
    EXPECT_EQ(FileNameOf(PathOf(name)), name);
  }
}

}  // namespace
}  // namespace oncard
