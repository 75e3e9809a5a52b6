// The rooms of docs/architecture.md: which folders there are, and which of them a source may
// include. Includes contain the path from the root of the project, otherwise they would not
// compile, so the text of a source shows what it includes; the compiler's dependency files do not
// show which file includes it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "base/files.h"

namespace oncard::docs {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

namespace fs = std::filesystem;

const fs::path kRoot = ONCARD_SOURCE_DIR;

/// For each room the rooms that it may include.
using Rooms = std::map<std::string, std::set<std::string>>;

std::vector<std::string> NamesIn(const std::string& cell) {
  static const std::regex kName(R"(`([a-z0-9_/-]+)`)");
  std::vector<std::string> names;
  for (std::sregex_iterator name(cell.begin(), cell.end(), kName), end; name != end; ++name) {
    names.push_back((*name)[1]);
  }
  return names;
}

/// Reads the table of a page whose first column is called `first`: the second column is what a room
/// owns, the third one what it may include.
Rooms ReadRooms(const std::string& page, const std::string& first = "room") {
  static const std::regex kRow(R"(\n\| `([a-z0-9_/-]+)` \|[^|\n]*\|([^|\n]*)\|[^|\n]*\|)");
  const size_t begin = page.find("\n| " + first + " |");
  if (begin == std::string::npos) return {};
  const std::string table = page.substr(begin, page.find("\n\n", begin) - begin);
  Rooms rooms;
  for (std::sregex_iterator row(table.begin(), table.end(), kRow), end; row != end; ++row) {
    for (const std::string& name : NamesIn((*row)[2])) rooms[(*row)[1]].insert(name);
    rooms.try_emplace((*row)[1]);
  }
  return rooms;
}

/// The innermost room that contains a path; empty if there is none.
std::string RoomOf(const fs::path& path, const Rooms& rooms) {
  for (fs::path folder = path.parent_path(); !folder.empty(); folder = folder.parent_path()) {
    if (rooms.contains(folder)) return folder;
  }
  return {};
}

/// The source without the contents of its raw strings, which are not its own code.
std::string WithoutRawStrings(std::string source) {
  for (size_t begin = 0; (begin = source.find("R\"", begin)) != std::string::npos;) {
    const size_t open = source.find('(', begin);
    if (open == std::string::npos) break;
    const std::string closing = ')' + source.substr(begin + 2, open - begin - 2) + '"';
    const size_t close = source.find(closing, open);
    source.erase(begin, close == std::string::npos ? close : close + closing.size() - begin);
  }
  return source;
}

/// The project's files that a source includes.
std::vector<std::string> IncludesOf(const std::string& source) {
  static const std::regex kInclude(R"re((?:^|\n)\s*#\s*include "([^"]+)")re");
  const std::string code = WithoutRawStrings(source);
  std::vector<std::string> includes;
  for (std::sregex_iterator each(code.begin(), code.end(), kInclude), end; each != end; ++each) {
    includes.push_back((*each)[1]);
  }
  return includes;
}

/// The name in the table for the system's services, which is not a folder.
constexpr char kSystem[] = "system";

/// The headers of the standard library and of the system that a source includes.
std::vector<std::string> SystemHeadersOf(const std::string& code) {
  static constexpr std::string_view kInclude = "#include <";
  std::vector<std::string> headers;
  for (size_t at = 0; (at = code.find(kInclude, at)) != std::string::npos;) {
    at += kInclude.size();
    headers.push_back(code.substr(at, code.find('>', at) - at));
  }
  return headers;
}

/// True if a source uses threads, locks, signals, files, the clock or the environment. Paths are
/// only text.
bool UsesSystem(const std::string& source) {
  static const std::set<std::string> kHeaders = {"chrono",   "condition_variable",
                                                 "csignal",  "ctime",
                                                 "dirent.h", "dlfcn.h",
                                                 "fcntl.h",  "fstream",
                                                 "future",   "mutex",
                                                 "poll.h",   "pthread.h",
                                                 "sched.h",  "semaphore",
                                                 "latch",    "shared_mutex",
                                                 "thread",   "signal.h",
                                                 "time.h",   "unistd.h"};
  const std::string code = WithoutRawStrings(source);
  for (const std::string& header : SystemHeadersOf(code)) {
    if (kHeaders.contains(header) || header.starts_with("sys/") || header.starts_with("linux/")) {
      return true;
    }
  }
  static constexpr std::string_view kFileSystem = "filesystem::";
  for (size_t at = 0; (at = code.find(kFileSystem, at)) != std::string::npos;) {
    at += kFileSystem.size();
    if (code.compare(at, 4, "path") != 0) return true;
  }
  return code.find("getenv(") != std::string::npos || code.find("fopen(") != std::string::npos;
}

bool IsSource(const fs::path& path) {
  static const std::set<std::string> kEndings = {".h", ".cc", ".inc", ".def", ".re", ".yy"};
  return kEndings.contains(path.extension());
}

/// The sources in the folders of the rooms, with paths from the root.
std::vector<fs::path> Sources(const Rooms& rooms) {
  std::set<fs::path> sources;
  for (const auto& [room, included] : rooms) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / room)) {
      if (IsSource(entry.path())) sources.insert(entry.path().lexically_relative(kRoot));
    }
  }
  return {sources.begin(), sources.end()};
}

/// Appends `room` after all rooms that it may include; false if there is a cycle.
bool Visit(const std::string& room, const Rooms& rooms, std::set<std::string>* open,
           std::vector<std::string>* order) {
  if (std::ranges::find(*order, room) != order->end()) return true;
  if (!open->insert(room).second) return false;
  for (const std::string& below : rooms.at(room)) {
    if (below != kSystem && !Visit(below, rooms, open, order)) return false;
  }
  order->push_back(room);
  return true;
}

Rooms RoomsOfTheProject() { return ReadRooms(ReadFile(kRoot / "docs/architecture.md").value()); }

TEST(RoomsTest, AreTheRowsOfTheTable) {
  EXPECT_THAT(ReadRooms("text\n| room | owns | may include | must not know |\n|---|---|---|---|\n"
                        "| `base` | texts | nothing | programs |\n"
                        "| `vm/x` | `this` | `base` | time |\n"),
              ElementsAre(Pair("base", IsEmpty()), Pair("vm/x", ElementsAre("base"))));
}

TEST(RoomsTest, AFileIsInTheInnermostRoom) {
  const Rooms rooms = {{"vm", {}}, {"vm/x", {}}};
  EXPECT_EQ(RoomOf("vm/x/y/a.h", rooms), "vm/x");
  EXPECT_EQ(RoomOf("vm/y/a.h", rooms), "vm");
  EXPECT_EQ(RoomOf("base/a.h", rooms), "");
}

TEST(RoomsTest, IncludesAreThoseOfTheSourceItself) {
  EXPECT_THAT(IncludesOf("#include \"a/b.h\"\n#include <vector>\n  #  include \"c.def\"\n"
                         "const char* kText = R\"(\n#include \"d.h\"\n)\";\n"),
              ElementsAre("a/b.h", "c.def"));
}

TEST(RoomsTest, TheSystemIsThreadsFilesClockAndEnvironment) {
  EXPECT_TRUE(UsesSystem("#include <sys/stat.h>\n"));
  EXPECT_TRUE(UsesSystem("#include <mutex>\n"));
  EXPECT_TRUE(UsesSystem("if (std::filesystem::exists(path)) return;"));
  EXPECT_TRUE(UsesSystem("const char* list = std::getenv(name);"));
  EXPECT_FALSE(UsesSystem("#include <atomic>\nstd::filesystem::path(name).stem();"));
  EXPECT_FALSE(UsesSystem("const char* kText = R\"(#include <mutex>)\";"));
}

TEST(ArchitectureTest, EveryRoomIsAFolderAndNamesRooms) {
  const Rooms rooms = RoomsOfTheProject();
  EXPECT_FALSE(rooms.empty());
  for (const auto& [room, included] : rooms) {
    EXPECT_TRUE(fs::is_directory(kRoot / room)) << room;
    for (const std::string& name : included) {
      EXPECT_TRUE(name == kSystem || rooms.contains(name)) << room << " may include " << name;
    }
  }
}

TEST(ArchitectureTest, NoRoomIncludesItselfByWayOfOthers) {
  const Rooms rooms = RoomsOfTheProject();
  std::vector<std::string> order;
  for (const auto& [room, included] : rooms) {
    std::set<std::string> open;
    ASSERT_TRUE(Visit(room, rooms, &open, &order)) << room;
  }
}

TEST(ArchitectureTest, SourcesIncludeWhatTheirRoomMay) {
  const Rooms rooms = RoomsOfTheProject();
  std::map<std::string, std::set<std::string>> included;
  for (const fs::path& source : Sources(rooms)) {
    const std::string room = RoomOf(source, rooms);
    const std::string text = ReadFile(kRoot / source).value();
    if (UsesSystem(text)) {
      included[room].insert(kSystem);
      EXPECT_TRUE(rooms.at(room).contains(kSystem)) << source << " uses the system";
    }
    for (const std::string& name : IncludesOf(text)) {
      const std::string other = RoomOf(name, rooms);
      // A name without a folder is a file generated for this source.
      if (other == room || name.find('/') == std::string::npos) continue;
      included[room].insert(other);
      EXPECT_TRUE(rooms.at(room).contains(other)) << source << " includes " << name;
    }
  }
  // Permissions that no source needs are errors too.
  for (const auto& [room, may] : rooms) {
    for (const std::string& other : may) {
      EXPECT_TRUE(included[room].contains(other)) << room << " never includes " << other;
    }
  }
}

// Whether a reader finds the rooms is tried with readers; here the list is only kept up to date.
TEST(ArchitectureTest, TenBugsHaveRoomsOfTheTable) {
  static const std::regex kRow(R"(\n\| [^|\n]*\| `([a-z/]+)` \|)");
  const Rooms rooms = RoomsOfTheProject();
  const std::string page = ReadFile(kRoot / "tests/docs/bugs.md").value();
  std::set<std::string> named;
  for (std::sregex_iterator row(page.begin(), page.end(), kRow), end; row != end; ++row) {
    EXPECT_TRUE(rooms.contains((*row)[1])) << (*row)[1];
    named.insert((*row)[1]);
  }
  EXPECT_EQ(named.size(), 10u);
}

// A package of web/ names those that it uses in its package.json.
TEST(ArchitectureTest, PackagesUseWhatTheTableSays) {
  static const std::regex kPackage(R"re("@oncard/([a-z-]+)": ")re");
  const Rooms packages = ReadRooms(ReadFile(kRoot / "docs/architecture.md").value(), "package");
  EXPECT_FALSE(packages.empty());
  for (const auto& entry : fs::directory_iterator(kRoot / "web")) {
    if (!fs::exists(entry.path() / "package.json")) continue;
    const std::string package = entry.path().lexically_relative(kRoot).generic_string();
    ASSERT_TRUE(packages.contains(package)) << package;
    const std::string text = ReadFile(entry.path() / "package.json").value();
    std::set<std::string> used;
    for (std::sregex_iterator each(text.begin(), text.end(), kPackage), end; each != end; ++each) {
      used.insert("web/" + (*each)[1].str());
    }
    EXPECT_EQ(used, packages.at(package)) << package;
  }
}

}  // namespace
}  // namespace oncard::docs
