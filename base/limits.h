// How large an input may be, in one place. Files come from anywhere: these bounds are judged while
// a file is read, before anything is built from it. docs/limits.md is their manual page;
// tests/limits accuses each at its bound and one past it.
#pragma once

#include <cstddef>
#include <string_view>

namespace oncard {

/// A kind of file that is read as a whole, and how many bytes of it at most.
struct FileKind {
  std::string_view name_en;
  std::string_view name_zh;
  size_t bytes_max;
};

inline constexpr size_t kMebibyte = size_t{1} << 20;

/// A motion program in C. The same bound holds for the program and all it includes together.
inline constexpr FileKind kSourceKind = {"a program", "程序", 4 * kMebibyte};
/// A .bin or .ini: no program within the card's limits is larger.
inline constexpr FileKind kObjectKind = {"an object file", "目标文件", 256 * kMebibyte};
inline constexpr FileKind kScenarioKind = {"a scenario", "场景文件", 1 * kMebibyte};
inline constexpr FileKind kScheduleKind = {"a schedule", "调度文件", 64 * kMebibyte};
inline constexpr FileKind kSearchKind = {"a search file", "搜索文件", 1024 * kMebibyte};
/// The vendor's .cfg.
inline constexpr FileKind kConfigKind = {"a configuration", "配置文件", 1 * kMebibyte};
/// What this project itself writes and reads back.
inline constexpr FileKind kOwnKind = {"a file", "文件", 1024 * kMebibyte};

/// Tokens of a program and all it includes.
inline constexpr size_t kTokenMax = size_t{1} << 20;

/// Brackets within brackets of a scenario's value, parts of a dotted key, and keys in all.
inline constexpr size_t kTomlDepthMax = 32;
inline constexpr size_t kTomlKeyPartMax = 32;
inline constexpr size_t kTomlKeyMax = 100'000;

}  // namespace oncard
