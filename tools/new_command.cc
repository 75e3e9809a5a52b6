// oncard new: a folder with a motion program, its scenario and all that tests them, and with a host
// program if one is asked for. The files are those of tools/new. Tested by
// tests/tools/new_command_test.cc, and with host programs by tests/tools/new_hosts_test.cc.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "base/files.h"
#include "runtime/scenario/file/scenario_schema.h"
#include "tools/commands.h"
#include "tools/folders.h"
#include "tools/new_templates.h"

namespace oncard::tools {
namespace {

/// The names of files made of it stay far below the 255 bytes that file systems allow.
constexpr size_t kLongestName = 64;

/// What the host of a project is written in; a set of bits.
enum HostKind : unsigned {
  kNoHost = 1,
  kHostInC = 2,
  kHostInCpp = 4,
  kHostInCsharp = 8,
  kHostInPython = 16,
};
constexpr unsigned kHostByCmake = kHostInC | kHostInCpp;
constexpr unsigned kHostProgram = kHostByCmake | kHostInCsharp;
constexpr unsigned kEvery = kNoHost | kHostProgram | kHostInPython;

struct HostKindInfo {
  HostKind kind;
  std::string_view option;    ///< the value of --host; also the ending of the source
  std::string_view language;  ///< its name in CMake
  std::string_view packages;  ///< of Debian, with which the project is built and tested
  std::string_view own;       ///< packages of oncard that it needs, for the README
};

constexpr std::array kHostKinds = {
    HostKindInfo{kNoHost, "", "", "", "`oncard`, `libgts1`"},
    HostKindInfo{kHostInC, "c", "C", "cmake gcc libc6-dev make",
                 "`oncard`, `libgts1`, `libgts-dev`"},
    HostKindInfo{kHostInCpp, "cpp", "CXX", "cmake g++ make", "`oncard`, `libgts1`, `libgts-dev`"},
    HostKindInfo{kHostInCsharp, "cs", "", "mono-mcs mono-runtime",
                 "`oncard`, `libgts1`, `libgts-dev`"},
    HostKindInfo{kHostInPython, "python", "", "python3-pytest",
                 "`oncard`, `libgts1`, `python3-oncard`"},
};

/// A file of a project, and the template of which it is made. Several in a row with one path make
/// one file together.
struct ProjectFile {
  std::string_view path;
  std::string_view origin;  ///< in tools/new; in Chinese NAME.zh-CN.md in place of NAME.md
  unsigned kinds;           ///< the projects that have it
};

constexpr std::array kProjectFiles = {
    ProjectFile{"@NAME@.c", "program.c", kEvery},
    ProjectFile{"@NAME@.toml", "scenario.toml", kEvery},
    ProjectFile{"@HOST@", "host.c", kHostInC},
    ProjectFile{"@HOST@", "host.cpp", kHostInCpp},
    ProjectFile{"@HOST@", "host.cs", kHostInCsharp},
    ProjectFile{"@NAME@.host.toml", "host.toml", kHostByCmake},
    ProjectFile{"@NAME@.host.toml", "host_cs.toml", kHostInCsharp},
    ProjectFile{"CMakeLists.txt", "CMakeLists.txt", kHostByCmake},
    ProjectFile{"drive_@NAME@.py", "drive.py", kHostInPython},
    ProjectFile{"test_@NAME@.py", "test_python.py", kHostInPython},
    ProjectFile{"test.sh", "test.sh", kNoHost},
    ProjectFile{"test.sh", "test_cmake.sh", kHostByCmake},
    ProjectFile{"test.sh", "test_cs.sh", kHostInCsharp},
    ProjectFile{"test.sh", "test_python.sh", kHostInPython},
    ProjectFile{"README.md", "project.md", kEvery},
    ProjectFile{"README.md", "project_host.md", kHostProgram},
    ProjectFile{"README.md", "project_cmake.md", kHostByCmake},
    ProjectFile{"README.md", "project_cs.md", kHostInCsharp},
    ProjectFile{"README.md", "project_python.md", kHostInPython},
    ProjectFile{"Dockerfile", "Dockerfile", kEvery},
    ProjectFile{"packages/install.sh", "install.sh", kEvery},
    ProjectFile{".github/workflows/test.yml", "github.yml", kEvery},
    ProjectFile{".gitlab-ci.yml", "gitlab.yml", kEvery},
    ProjectFile{".gitignore", "gitignore", kEvery},
    ProjectFile{".vscode/settings.json", "vscode_settings.json", kEvery},
};

struct NewOptions {
  std::string name;
  std::string host;
};

struct FileText {
  std::string path;
  std::string text;
};

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// Names of devices, which no file or folder of Windows can have, whatever its ending.
bool IsDeviceOfWindows(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (name == "con" || name == "prn" || name == "aux" || name == "nul") return true;
  return name.size() == 4 && (name.starts_with("com") || name.starts_with("lpt")) &&
         IsDigit(name[3]);
}

/// Why files, folders and projects cannot be called so.
std::optional<Message> RefusalOf(const std::string& name) {
  const bool is_name = !name.empty() && IsLetter(name[0]) && std::ranges::all_of(name, [](char c) {
    return IsLetter(c) || IsDigit(c) || c == '_';
  });
  if (!is_name) {
    return MakeMessage(
        "'{0}' cannot be the name of a project: use letters, digits and _, and begin with a letter",
        "“{0}”不能作为项目名称：请使用字母、数字和 _，并以字母开头", name);
  }
  if (name.size() > kLongestName) {
    return MakeMessage("the name of the project has {0} characters: use at most {1}",
                       "项目名称有 {0} 个字符：最多 {1} 个", name.size(), kLongestName);
  }
  if (IsDeviceOfWindows(name)) {
    return MakeMessage(
        "'{0}' cannot be the name of a project: Windows has a device of this name; use another one",
        "“{0}”不能作为项目名称：它是 Windows 的设备名；请换一个名称", name);
  }
  return std::nullopt;
}

void Replace(std::string_view placeholder, std::string_view value, std::string* text) {
  for (size_t at = text->find(placeholder); at != std::string::npos;
       at = text->find(placeholder, at + value.size())) {
    text->replace(at, placeholder.size(), value);
  }
}

std::string Filled(std::string_view text, const std::string& name, const HostKindInfo& host) {
  std::string filled(text);
  Replace("@HOST@", fmt::format("{}_host.{}", name, host.option), &filled);
  Replace("@LANGUAGE@", host.language, &filled);
  // Without a space at the end of the line where there are none.
  Replace(" @PACKAGES@", host.packages.empty() ? "" : fmt::format(" {}", host.packages), &filled);
  Replace("@DEBS@", host.own, &filled);
  Replace("@NAME@", name, &filled);
  return filled;
}

/// The text of a template; every row of kProjectFiles has one.
std::string_view TextOf(std::string_view origin, Language language) {
  std::string name(origin);
  if (language == Language::kChinese && name.ends_with(".md")) {
    name.insert(name.size() - 3, ".zh-CN");
  }
  const auto templates = NewTemplates();
  const auto found = std::ranges::find(templates, name, &NewTemplate::name);
  return found == templates.end() ? std::string_view() : found->text;
}

/// The files of a project, with the folder in front.
std::vector<FileText> FilesOf(const std::string& name, const HostKindInfo& host,
                              Language language) {
  std::vector<FileText> files;
  for (const ProjectFile& row : kProjectFiles) {
    if ((row.kinds & host.kind) == 0) continue;
    const std::string path = name + '/' + Filled(row.path, name, host);
    if (files.empty() || files.back().path != path) files.push_back({path, {}});
    files.back().text += Filled(TextOf(row.origin, language), name, host);
  }
  files.push_back({name + "/.vscode/scenario.schema.json", runtime::ScenarioSchema(language)});
  return files;
}

/// Writes all files, or none: what is there already stops it, and a failure removes what it has
/// written. Returns the exit code.
int WriteFiles(const Invocation& invocation, const std::vector<FileText>& files) {
  for (const FileText& file : files) {
    if (!FileExists(file.path)) continue;
    return Fail(invocation, kExitUnreadable,
                MakeMessage("'{0}' exists already; nothing was written: choose another name, or "
                            "move it away",
                            "“{0}”已存在；没有写入任何文件：请换一个名称，或将其移走", file.path));
  }
  for (size_t i = 0; i < files.size(); ++i) {
    const std::string& path = files[i].path;
    auto written = MakeFolders(path.substr(0, path.rfind('/')));
    if (written.ok()) written = WriteFileAtomically(path, files[i].text);
    if (written.ok()) continue;
    for (size_t before = 0; before < i; ++before) std::remove(files[before].path.c_str());
    return Fail(invocation, kExitUnreadable, written.error().message);
  }
  return kExitOk;
}

int MakeProject(const NewOptions& options, const Invocation& invocation) {
  if (const auto refusal = RefusalOf(options.name)) return Fail(invocation, kExitUsage, *refusal);
  const HostKindInfo& host = *std::ranges::find(kHostKinds, options.host, &HostKindInfo::option);
  const int code = WriteFiles(invocation, FilesOf(options.name, host, invocation.language));
  if (code != kExitOk) return code;
  // Mono runs the host only after it has been compiled.
  const std::string_view first = host.kind == kHostInCsharp ? "sh test.sh" : "oncard test .";
  PrintResult(invocation.Say(
      MakeMessage("{0}: begin with 'cd {0}' and '{1}'; README.md says the rest\n",
                  "{0}：先执行“cd {0}”和“{1}”；其余见 README.md\n", options.name, first)));
  return kExitOk;
}

}  // namespace

void AddNew(CLI::App& app, Invocation& invocation) {
  auto options = std::make_shared<NewOptions>();
  CLI::App* command =
      AddCommand(app, invocation, "new",
                 {"make a project: a program, its scenario, CI and a container that test it",
                  "新建项目：程序、场景，以及测试它们的 CI 和容器"},
                 [options, &invocation] { return MakeProject(*options, invocation); });
  command
      ->add_option("name", options->name,
                   invocation.Say({"the project and its folder: letters, digits and _",
                                   "项目及其文件夹的名称：字母、数字和 _"}))
      ->required()
      ->type_name("NAME");
  command
      ->add_option("--host", options->host,
                   invocation.Say({"with a host program in c, cpp or cs, or with tests in python",
                                   "附带 c、cpp 或 cs 主机程序，或 python 测试"}))
      ->type_name("LANGUAGE")
      ->check(CLI::IsMember({"c", "cpp", "cs", "python"}).description(""));
}

}  // namespace oncard::tools
