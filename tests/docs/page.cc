#include "tests/docs/page.h"

#include <fmt/core.h>

#include <algorithm>
#include <regex>

namespace oncard::docs {
namespace {

constexpr std::string_view kFence = "```";

std::vector<std::string> Lines(std::string_view page) {
  std::vector<std::string> lines;
  while (!page.empty()) {
    const size_t end = std::min(page.find('\n'), page.size());
    lines.emplace_back(page.substr(0, end));
    page.remove_prefix(std::min(end + 1, page.size()));
  }
  return lines;
}

std::string WithoutComment(const std::string& line, std::string_view language) {
  const std::string_view mark = language == "c" ? "//" : language == "sh" ? "#" : "";
  if (mark.empty()) return line;
  const std::string code = line.substr(0, line.find(mark));
  return code.substr(0, code.find_last_not_of(' ') + 1);
}

}  // namespace

std::string Skeleton(std::string_view page) {
  std::string skeleton;
  bool in_code = false;
  std::string language;
  size_t rows = 0;
  const auto end_table = [&] {
    if (rows > 0) skeleton += fmt::format("table of {} rows\n", rows);
    rows = 0;
  };
  for (const std::string& line : Lines(page)) {
    if (!in_code && line.starts_with('|')) {
      ++rows;
      continue;
    }
    end_table();
    if (line.starts_with(kFence)) {
      in_code = !in_code;
      if (in_code) language = line.substr(kFence.size());
      skeleton += line + '\n';
    } else if (in_code) {
      skeleton += WithoutComment(line, language) + '\n';
    } else if (line.starts_with('#')) {
      skeleton += fmt::format("heading of level {}\n", line.find_first_not_of('#'));
    }
  }
  end_table();
  return skeleton;
}

std::vector<std::string> Links(std::string_view page) {
  static const std::regex kLink(R"(\]\(([^)#]+)(#[^)]*)?\))");
  std::vector<std::string> links;
  bool in_code = false;
  for (const std::string& line : Lines(page)) {
    if (line.starts_with(kFence)) in_code = !in_code;
    if (in_code) continue;
    for (std::sregex_iterator link(line.begin(), line.end(), kLink), end; link != end; ++link) {
      const std::string target = (*link)[1];
      if (!target.starts_with("http")) links.push_back(target);
    }
  }
  return links;
}

std::vector<CodeBlock> CodeBlocks(std::string_view page) {
  std::vector<CodeBlock> blocks;
  bool in_code = false;
  for (const std::string& line : Lines(page)) {
    if (line.starts_with(kFence)) {
      in_code = !in_code;
      if (in_code) blocks.push_back({line.substr(kFence.size()), ""});
    } else if (in_code) {
      blocks.back().text += line + '\n';
    }
  }
  return blocks;
}

}  // namespace oncard::docs
