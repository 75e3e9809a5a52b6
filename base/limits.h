// The largest accepted inputs, in one place. Files are untrusted: these bounds are checked while a
// file is read, before its content is processed. docs/limits.md describes them;
// tests/tools/limits_test.cc tests each at its bound and just above it.
#pragma once

#include <cstddef>
#include <string_view>

namespace oncard {

/// A kind of file that is read as a whole, and its largest size in bytes.
struct FileKind {
  std::string_view name_en;
  std::string_view name_zh;
  size_t bytes_max;
};

inline constexpr size_t kMebibyte = size_t{1} << 20;

/// A motion program in C. The same bound applies to the program together with all files that it
/// includes.
inline constexpr FileKind kSourceKind = {"a program", "程序", 4 * kMebibyte};
/// A .bin or .ini: no program within the card's limits is larger.
inline constexpr FileKind kObjectKind = {"an object file", "目标文件", 256 * kMebibyte};
inline constexpr FileKind kScenarioKind = {"a scenario", "场景文件", 1 * kMebibyte};
inline constexpr FileKind kScheduleKind = {"a schedule", "调度文件", 64 * kMebibyte};
inline constexpr FileKind kSearchKind = {"a search file", "搜索文件", 1024 * kMebibyte};
/// A request of the session protocol.
inline constexpr FileKind kRequestKind = {"a request", "请求", 64 * kMebibyte};
/// The vendor's .cfg.
inline constexpr FileKind kConfigKind = {"a configuration", "配置文件", 1 * kMebibyte};
/// A description of an EtherCAT bus: configuration tools write commands for each slave, too.
inline constexpr FileKind kEniKind = {"an ENI file", "ENI 文件", 8 * kMebibyte};
/// Files that oncard itself writes and reads back.
inline constexpr FileKind kOwnKind = {"a file", "文件", 1024 * kMebibyte};

/// Tokens of a program and all it includes.
inline constexpr size_t kTokenMax = size_t{1} << 20;

/// Bytes of the text that structured C becomes: room for all statements of a card, 32 functions of
/// 32767.
inline constexpr size_t kLoweredBytesMax = 64 * kMebibyte;

/// Nested brackets of a scenario's value, parts of a dotted key, and total number of keys.
inline constexpr size_t kTomlDepthMax = 32;
inline constexpr size_t kTomlKeyPartMax = 32;
inline constexpr size_t kTomlKeyMax = 100'000;

/// Nested elements of an ENI file. Those of configuration tools have some ten.
inline constexpr size_t kXmlDepthMax = 64;

}  // namespace oncard
