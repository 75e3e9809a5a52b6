// A card opened through the C API with the virtual clock, and a folder for its program files.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "gts.h"
#include "test_programs.h"

namespace oncard::runtime {

class OpenCard : public testing::Test {
 protected:
  void SetUp() override {
    std::string folder = testing::TempDir() + "oncard_host_XXXXXX";
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    folder_ = folder + "/";
    setenv("ONCARD_CLOCK", "virtual", 1);
    ASSERT_EQ(GT_Open(), 0);
  }
  void TearDown() override {
    GT_Close();
    std::filesystem::remove_all(folder_);
  }

  /// Writes a file into the folder and returns its path.
  std::string WriteText(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ + name, std::ios::binary) << text;
    return folder_ + name;
  }

  /// Compiles and downloads a program.
  void Download(std::string_view program) const {
    TCompileInfo nowhere{};
    ASSERT_EQ(GT_Compile(WriteText("p.c", program).c_str(), &nowhere), 0);
    ASSERT_EQ(GT_Download((folder_ + "p.bin").c_str()), 0);
  }

  static TVarInfo Global(const char* name) {
    TVarInfo info{};
    EXPECT_EQ(GT_GetVarId(nullptr, name, &info), 0) << name;
    return info;
  }
  static double ReadGlobal(const char* name) {
    TVarInfo info = Global(name);
    double value = -1;
    EXPECT_EQ(GT_GetVarValue(-1, &info, &value), 0) << name;
    return value;
  }
  static void Run(short thread, short function, short page) {
    ASSERT_EQ(GT_Bind(thread, function, page), 0);
    ASSERT_EQ(GT_RunThread(thread), 0);
  }
  /// Units of 125 us since the last reset.
  static unsigned long Clock() {
    unsigned long clock = 0;
    EXPECT_EQ(GT_GetClockHighPrecision(&clock), 0);
    return clock;
  }

  std::string folder_;
};

}  // namespace oncard::runtime
