// run --plot, with and without gnuplot; the pictures of the documentation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "base/files.h"
#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kSource = ONCARD_SOURCE_DIR;
const std::string kBlink = kSource + "/samples/09_blink/blink.toml";

bool HasGnuplot() { return std::filesystem::exists("/usr/bin/gnuplot"); }

#define REQUIRE_GNUPLOT() \
  if (!HasGnuplot()) GTEST_SKIP() << "gnuplot is not installed: apt-get install gnuplot-nox"

std::string Draw(const std::string& scenario, const ScratchFolder& scratch,
                 const std::string& name) {
  const ProcessResult result = RunOncard({"run", scenario, "--plot", scratch.path() + "/" + name});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return scratch.Read(name);
}

TEST(Plot, DrawsTheSameBytesEveryTime) {
  REQUIRE_GNUPLOT();
  const ScratchFolder scratch;
  const std::string first = Draw(kBlink, scratch, "a.svg");
  EXPECT_THAT(first, HasSubstr("<svg"));
  EXPECT_THAT(first, HasSubstr("gpo[1]"));
  EXPECT_EQ(first, Draw(kBlink, scratch, "b.svg"));
}

TEST(Plot, DrawsPng) {
  REQUIRE_GNUPLOT();
  const ScratchFolder scratch;
  EXPECT_THAT(Draw(kBlink, scratch, "a.png"), StartsWith("\x89PNG"));
}

TEST(Plot, SaysHowToInstallGnuplot) {
  const ScratchFolder scratch;
  const ProcessResult result =
      RunOncard({"run", kBlink, "--plot", scratch.path() + "/a.svg"}, {}, {"PATH=/nonexistent"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, "oncard: gnuplot is not installed: apt-get install gnuplot-nox\n");
  EXPECT_FALSE(scratch.Has("a.svg"));
}

TEST(Plot, SaysWhenThereIsNothingToSee) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", "int f()\n{\n  return 1;\n}\n");
  const ProcessResult result = RunOncard({"run", source, "--plot", scratch.path() + "/a.svg"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "oncard: nothing to draw: no value changed during the run\n");
}

TEST(Plot, DoctorNamesGnuplot) {
  const ProcessResult result = RunOncard({"doctor"}, {}, {"PATH=/nonexistent"});
  EXPECT_THAT(result.out, HasSubstr("pictures (--plot): gnuplot is not installed: apt-get install "
                                    "gnuplot-nox\n"));
}

// The line of an SVG with the version of gnuplot.
std::string Producer(const std::string& svg) {
  const size_t begin = svg.find("<desc>");
  return begin == std::string::npos ? "" : svg.substr(begin, svg.find('\n', begin) - begin);
}

// A picture of the documentation: "10_trap", or "32_multi_axis_look_ahead.lines" of one of a
// sample's hosts.
struct Pictured {
  std::string folder;    // of the sample
  std::string scenario;  // without its ending
  std::string host;      // empty: a program of the card
};

Pictured PicturedBy(const std::string& picture) {
  const size_t dot = picture.find('.');
  Pictured sample;
  sample.folder = kSource + "/samples/" + picture.substr(0, dot);
  const std::string source =
      dot == std::string::npos ? picture.substr(picture.find('_') + 1) : picture.substr(dot + 1);
  sample.scenario = sample.folder + "/" + source;
  if (std::filesystem::exists(sample.scenario + ".toml")) return sample;
  std::string name = "sample_" + picture;
  std::ranges::replace(name, '.', '_');
  // A host that opens files has a folder of its own.
  const std::string built = ONCARD_BUILD_DIR "/samples/";
  const std::string own = built + picture + "/" + name;
  sample.host = std::filesystem::exists(own) ? own : built + name;
  return sample;
}

std::string DrawSample(const Pictured& sample) {
  const ScratchFolder scratch;
  if (sample.host.empty()) return Draw(sample.scenario + ".toml", scratch, "picture.svg");
  // Beside the files that the host may open.
  for (const auto& entry : std::filesystem::directory_iterator(sample.folder)) {
    std::filesystem::copy(entry.path(), scratch.path() + "/" + entry.path().filename().string());
  }
  const ProcessResult result = RunOncard({"exec", "--scenario", sample.scenario + ".host.toml",
                                          "--plot", "picture.svg", "--", sample.host},
                                         scratch.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return scratch.Read("picture.svg");
}

bool CanDraw(const Pictured& sample) {
  return sample.host.empty() || std::filesystem::exists(sample.host);
}

// docs/pictures/10_trap.svg is the picture of samples/10_trap, and so on. After an intended change:
// ./x pictures.
TEST(Plot, PicturesOfTheDocumentationShowTheSamples) {
  REQUIRE_GNUPLOT();
  std::vector<std::filesystem::path> pictures;
  for (const auto& entry : std::filesystem::directory_iterator(kSource + "/docs/pictures")) {
    // The others show the playground.
    if (entry.path().extension() == ".svg") pictures.push_back(entry.path());
  }
  std::sort(pictures.begin(), pictures.end());
  ASSERT_FALSE(pictures.empty());
  for (const std::filesystem::path& picture : pictures) {
    const Pictured sample = PicturedBy(picture.stem().string());
    if (!CanDraw(sample)) continue;  // built with a sanitizer, without oncard exec
    const std::string committed = ReadFile(picture.string()).value();
    const std::string drawn = DrawSample(sample);
    if (Producer(drawn) != Producer(committed)) {
      GTEST_SKIP() << "drawn by another gnuplot: " << Producer(committed);
    }
    EXPECT_TRUE(drawn == committed) << picture << " differs: run ./x pictures";
  }
}

}  // namespace
}  // namespace oncard::tools
