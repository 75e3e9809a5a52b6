// The commands build, check, dump, verify and explain.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

using Json = nlohmann::json;

constexpr const char* kGood = "int sum;\nint f()\n{\n  sum = 3;\n  return sum;\n}\n";
constexpr const char* kBad = "int f()\n{\n  return total;\n}\n";

TEST(Build, WritesThePairBesideTheSourceAndSaysNothing) {
  const ScratchFolder scratch;
  const ProcessResult result = RunOncard({"build", scratch.Write("p.c", kGood)});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_TRUE(scratch.Has("p.bin"));
  EXPECT_TRUE(scratch.Has("p.ini"));
}

TEST(Build, WritesIntoAFolderOnRequest) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", kGood);
  scratch.Write("out/keep", "");
  EXPECT_EQ(RunOncard({"build", "-o", scratch.path() + "/out", source}).exit_code, 0);
  EXPECT_TRUE(scratch.Has("out/p.bin"));
  EXPECT_FALSE(scratch.Has("p.bin"));
}

// The sizes of the vendor's own objects for example 10-1.
TEST(Build, ReproducesTheVendorsFileSizes) {
  const ScratchFolder scratch;
  const ProcessResult result = RunOncard({"build", "--vendor-format", "-o", scratch.path(), kSum});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(scratch.Read("sum.bin").size(), 140u);
  EXPECT_EQ(scratch.Read("sum.ini").size(), 129u);
}

TEST(Build, LeavesTheOldPairWhenTheProgramIsWrong) {
  const ScratchFolder scratch;
  scratch.Write("p.bin", "old");
  const ProcessResult result = RunOncard({"build", scratch.Write("p.c", kBad)});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(scratch.Read("p.bin"), "old");
  EXPECT_FALSE(scratch.Has("p.ini"));
}

TEST(Build, ExitsWithThreeWhenAFileCannotBeRead) {
  const ProcessResult result = RunOncard({"build", "/nonexistent/p.c"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("/nonexistent/p.c"));
}

TEST(Build, SaysWhatItsOutputIs) {
  const ScratchFolder scratch;
  scratch.Write("p.c", "int n;\nint f()\n{\n  n = 1;\n}\n");
  scratch.Write("sub/keep", "");
  const ProcessResult built = RunOncard({"build", "p.c", "-o", "p.c"}, scratch.path());
  EXPECT_EQ(built.exit_code, 2);
  EXPECT_EQ(built.err,
            "oncard: 'p.c' is a file: -o names the folder of the objects, whose names are those of "
            "the sources\n");
  for (const char* folder : {"sub", "sub/"}) {
    const ProcessResult lowered = RunOncard({"lower", "p.c", "-o", folder}, scratch.path());
    EXPECT_EQ(lowered.exit_code, 3);
    EXPECT_EQ(lowered.err, std::string("oncard: cannot write '") + folder +
                               "': it is a folder; name a file in it, as in 'sub/NAME'\n");
  }
}

TEST(Build, KeepsTheNamesOfCUnlessTheFilesAreAVendors) {
  const ScratchFolder scratch;
  const std::string source =
      scratch.Write("p.c",
                    "//@ structured\nstruct axis { int number, target; };\nstruct axis axis[3];\n"
                    "void t0(int n) { axis[2].target = n; }\n");
  const std::vector<std::string> run = {"run", scratch.path() + "/p.bin", "--thread=0=t0:n=4",
                                        "--show=axis[2].target"};
  ASSERT_EQ(RunOncard({"build", source}).exit_code, 0);
  EXPECT_THAT(RunOncard(run).out, HasSubstr("\naxis[2].target = 4\n"));
  ASSERT_EQ(RunOncard({"build", "--vendor-format", source}).exit_code, 0);
  EXPECT_THAT(RunOncard(run).err, HasSubstr("nothing is named 'axis[2].target'"));
}

TEST(Build, RefusesAnObject) { EXPECT_EQ(RunOncard({"build", "p.bin"}).exit_code, 2); }

TEST(Build, StoresTheWidthOfDouble) {
  const ScratchFolder scratch;
  RunOncard({"build", "--double=16.16", scratch.Write("p.c", kGood)});
  EXPECT_THAT(scratch.Read("p.ini"), HasSubstr("double=16.16"));
}

TEST(Build, FindsIncludedFiles) {
  const ScratchFolder scratch;
  scratch.Write("inc/n.h", "#define N 7\n");
  const std::string source = scratch.Write("p.c", "#include \"n.h\"\nint f()\n{\n  return N;\n}\n");
  EXPECT_EQ(RunOncard({"build", source}).exit_code, 1);
  EXPECT_EQ(RunOncard({"build", "-I", scratch.path() + "/inc", source}).exit_code, 0);
}

TEST(Check, ReportsOnStandardErrorInBothLanguages) {
  const ScratchFolder scratch;
  scratch.Write("p.c", kBad);
  const ProcessResult english = RunOncard({"check", "p.c"}, scratch.path());
  EXPECT_EQ(english.exit_code, 1);
  EXPECT_EQ(english.out, "");
  ExpectGolden("check_undeclared.txt", english.err);
  const ProcessResult chinese = RunOncard({"check", "--lang=zh", "p.c"}, scratch.path());
  ExpectGolden("check_undeclared_zh.txt", chinese.err);
}

TEST(Check, ShowsRepairsOfWhatCHasAndTheLanguageLacks) {
  const ScratchFolder scratch;
  scratch.Write("p.c",
                "int sum;\nint f(int n)\n{\n  int i;\n  i = 0;\n  while (i < n)\n  {\n"
                "    sum = sum + i * 2;\n    i = i + 1;\n  }\n  return sum;\n}\n");
  ExpectGolden("check_while.txt", RunOncard({"check", "p.c"}, scratch.path()).err);
  ExpectGolden("check_while_zh.txt", RunOncard({"check", "--lang=zh", "p.c"}, scratch.path()).err);
}

TEST(Check, IsSilentAboutAGoodProgram) {
  const ScratchFolder scratch;
  const ProcessResult result = RunOncard({"check", scratch.Write("p.c", kGood)});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_FALSE(scratch.Has("p.bin"));
}

TEST(Check, ColoursOnlyWhenTold) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", kBad);
  EXPECT_THAT(RunOncard({"check", source}).err, Not(HasSubstr("\x1b")));
  EXPECT_THAT(RunOncard({"check", "--color=always", source}).err, HasSubstr("\x1b"));
}

TEST(Check, GivesJsonAndSarifOnStandardOutput) {
  const ScratchFolder scratch;
  const std::string bad = scratch.Write("bad.c", kBad);
  const std::string good = scratch.Write("good.c", kGood);
  const ProcessResult json = RunOncard({"check", "--diagnostics=json", bad, good});
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_EQ(Json::parse(json.out)["code"], "MP027");
  const ProcessResult sarif = RunOncard({"check", "--format=sarif", bad, good});
  EXPECT_EQ(Json::parse(sarif.out)["runs"][0]["results"].size(), 1u);
}

TEST(Check, StopsAfterSoManyErrors) {
  const ScratchFolder scratch;
  const std::string source =
      scratch.Write("p.c", "int f()\n{\n  a = 1;\n  b = 1;\n  c = 1;\n  return 0;\n}\n");
  const std::string all = RunOncard({"check", source}).err;
  EXPECT_THAT(all, HasSubstr("3 errors"));
  const std::string one = RunOncard({"check", "--max-errors=1", source}).err;
  EXPECT_THAT(one, HasSubstr("1 error"));
}

constexpr const char* kLoop =
    "int v;\nint f()\n{\n  int i;\n  for (i = 0; i < 3; i++) { { v += i; } }\n  return v;\n}\n";

constexpr const char* kSuspicious = "int f()\n{\n  return 1;\n  return 2;\n  GT_Delay(1);\n}\n";

TEST(Check, TakesWarningsForErrorsOrLeavesThemOut) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", kSuspicious);
  const ProcessResult plain = RunOncard({"check", source});
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_THAT(plain.err, HasSubstr("warning MP136"));
  const ProcessResult errors = RunOncard({"check", "-Werror", source});
  EXPECT_EQ(errors.exit_code, 1);
  EXPECT_THAT(errors.err, HasSubstr("error MP136"));
  EXPECT_EQ(RunOncard({"check", "-Werror", "-Wno-unreachable", source}).err, "");
  EXPECT_EQ(RunOncard({"check", "-Wno-such", source}).exit_code, 2);
  EXPECT_EQ(RunOncard({"build", "-Werror", source}).exit_code, 1);
  const Json sarif = Json::parse(RunOncard({"check", "--format=sarif", source}).out);
  EXPECT_EQ(sarif["runs"][0]["results"][0]["level"], "warning");
}

TEST(Check, CorrectsInPlace) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", kLoop);
  const ProcessResult result = RunOncard({"check", "--fix", source});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("fix-its applied: 3"));
  EXPECT_EQ(RunOncard({"check", source}).err, "");
  EXPECT_EQ(scratch.Read("p.c").find('{', scratch.Read("p.c").find('{') + 1), std::string::npos);
}

TEST(Check, CorrectsIncludedFilesToo) {
  const ScratchFolder scratch;
  scratch.Write("n.h", "const int N = 7;\n");
  const std::string source = scratch.Write("p.c", "#include \"n.h\"\nint f()\n{\n  return N;\n}\n");
  EXPECT_EQ(RunOncard({"check", "--fix", source}).exit_code, 0);
  EXPECT_EQ(scratch.Read("n.h"), "#define N 7\n");
  EXPECT_EQ(scratch.Read("p.c"), "#include \"n.h\"\nint f()\n{\n  return N;\n}\n");
}

TEST(Check, KeepsAByteOrderMarkWhenItCorrects) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", std::string("\xEF\xBB\xBF") + kLoop);
  EXPECT_EQ(RunOncard({"check", "--fix", source}).exit_code, 0);
  EXPECT_THAT(scratch.Read("p.c"), StartsWith("\xEF\xBB\xBFint v;"));
}

TEST(Check, ReportsErrorsWithoutAFixIt) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", "int rate = 25;\nint f()\n{\n  rate++;\n}\n");
  const ProcessResult result = RunOncard({"check", "--fix", source});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("MP110"));
  EXPECT_EQ(scratch.Read("p.c"), "int rate = 25;\nint f()\n{\n  rate = rate + 1;\n}\n");
}

TEST(Check, ReadsStandardInput) {
  const ScratchFolder scratch;
  scratch.Write("bad.c", kBad);
  scratch.Write("loop.c", kLoop);
  const auto piped = [&](const std::string& file, const std::string& arguments) {
    return RunProgram(
        {"sh", "-c", ONCARD_BUILD_DIR "/bin/oncard check " + arguments + " < " + file},
        scratch.path());
  };
  const ProcessResult bad = piped("bad.c", "-");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_THAT(bad.err, HasSubstr("<stdin>:3:10: error MP027"));
  const ProcessResult corrected = piped("loop.c", "--fix -");
  EXPECT_EQ(corrected.exit_code, 0) << corrected.err;
  EXPECT_THAT(corrected.out, HasSubstr("goto lbl_loop;"));
  EXPECT_EQ(piped("loop.c", "--fix --format=json -").exit_code, 2);
  EXPECT_EQ(piped("/dev/zero", "-").exit_code, 3);
  EXPECT_EQ(piped("/dev/null", "-").exit_code, 0);
  const ProcessResult folder = piped(".", "-");
  EXPECT_EQ(folder.exit_code, 3);
  EXPECT_THAT(folder.err, HasSubstr("cannot read standard input"));
}

TEST(Dump, ListsInstructionsWithTheirLines) {
  const ProcessResult result = RunOncard({"dump", kSum});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("sum := sum + i"));
  EXPECT_TRUE(Json::accept(RunOncard({"dump", "--json", kSum}).out));
}

TEST(Verify, AcceptsItsOwnObjectsSilently) {
  const ScratchFolder scratch;
  RunOncard({"build", "-o", scratch.path(), kSum});
  const ProcessResult result = RunOncard({"verify", scratch.path() + "/sum.bin"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "");
}

TEST(Verify, SaysWhyADamagedObjectIsRefused) {
  const ScratchFolder scratch;
  RunOncard({"build", "-o", scratch.path(), kSum});
  const std::string bytes = scratch.Read("sum.bin");
  const std::string path = scratch.Write("sum.bin", bytes.substr(0, bytes.size() - 2));
  const ProcessResult text = RunOncard({"verify", path});
  EXPECT_EQ(text.exit_code, 1);
  EXPECT_THAT(text.err, HasSubstr("2008"));
  const Json json = Json::parse(RunOncard({"verify", "--format=json", path}).out);
  EXPECT_EQ(json[0]["accepted"], false);
  EXPECT_EQ(json[0]["code"], 2008);
}

TEST(Verify, ExitsWithThreeForAMissingFile) {
  EXPECT_EQ(RunOncard({"verify", "/nonexistent/p.bin"}).exit_code, 3);
}

TEST(Explain, PrintsThePageOfACode) {
  const std::string page = RunOncard({"explain", "MP027"}).out;
  EXPECT_THAT(page, HasSubstr("MP027"));
  EXPECT_EQ(RunOncard({"explain", "mp27"}).out, page);
  EXPECT_EQ(RunOncard({"explain", "27"}).out, page);
  EXPECT_EQ(RunOncard({"explain", "undeclared"}).out, page);
  EXPECT_NE(RunOncard({"--lang=zh", "explain", "MP027"}).out, page);
}

// A number may be a diagnostic, too: its page follows.
TEST(Explain, KnowsReturnCodes) {
  const std::string seven = RunOncard({"explain", "7"}).out;
  EXPECT_THAT(seven, StartsWith("return code 7\n\nany command\n    an argument is out of range"));
  EXPECT_THAT(seven, EndsWith("\n\n" + RunOncard({"explain", "MP007"}).out));
  EXPECT_THAT(RunOncard({"explain", "MP007"}).out, Not(HasSubstr("return code")));
  EXPECT_THAT(RunOncard({"explain", "-6"}).out,
              HasSubstr("GT_Open\n    the card cannot be opened"));
  EXPECT_THAT(RunOncard({"--lang=zh", "explain", "2008"}).out, StartsWith("返回值 2008\n"));
}

TEST(Explain, ListsAllCodesWithoutOne) {
  const std::string list = RunOncard({"explain"}).out;
  EXPECT_THAT(list, HasSubstr("MP027  undeclared\n"));
  EXPECT_THAT(list, HasSubstr("card   drive-off\n"));
}

TEST(Explain, HasAPageForEachWarningOfRuns) {
  EXPECT_THAT(RunOncard({"explain", "update-mask"}).out,
              AllOf(StartsWith("update-mask (warning of runs)\n\n    the mask of a start"),
                    HasSubstr("axis 3 is 1 << 2"), HasSubstr("\n\nMP139 ")));
  EXPECT_THAT(RunOncard({"--lang=zh", "explain", "drive-off"}).out,
              StartsWith("drive-off (运行警告)\n\n    轴在伺服使能关闭时运动\n"));
}

TEST(Explain, ListsThePagesThatContainAllWords) {
  const std::string list = RunOncard({"explain", "goto", "condition"}).out;
  EXPECT_THAT(list, HasSubstr("MP101 while-loop\n    the language has no 'while'; "));
  EXPECT_THAT(list, Not(HasSubstr("MP027")));
  EXPECT_THAT(RunOncard({"--lang=zh", "explain", "goto"}).out, HasSubstr("\n    不支持 'while'；"));
}

TEST(Explain, SaysWhatToTryWhenItKnowsNothing) {
  for (const char* name : {"MP999", "MPx", "-99", "undeclard"}) {
    const ProcessResult result = RunOncard({"explain", "--", name});
    EXPECT_EQ(result.exit_code, 2) << name;
    EXPECT_EQ(result.out, "") << name;
    EXPECT_THAT(result.err, HasSubstr(name));
  }
}

}  // namespace
}  // namespace oncard::tools
