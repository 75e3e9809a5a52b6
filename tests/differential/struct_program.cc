// Indices are made of local ints, which no call changes, and a call that changes what others read
// stands alone on the right of an assignment, so that no order of operands matters.
#include "struct_program.h"

#include <fmt/core.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "random_choices.h"

namespace oncard::differential {
namespace {

// The structures: two of the program, which begin with kPair, and those of the card.
constexpr int kPair = 0;
constexpr int kOuter = 1;
constexpr int kTrap = 2;
constexpr int kPid = 3;
constexpr int kTypes = 4;
constexpr int kNumber = -1;  // the type of a member that is no structure

constexpr const char* kNames[kTypes] = {"struct pair", "struct outer", "TTrapPrm", "TPid"};

struct Member {
  std::string name;
  std::string words;  // of its type
  int type = kNumber;
  int size = 0;  // of an array

  // On the card such a number has 16 bits behind the point, so it is always an integer below 2^31.
  bool IsReal() const { return words == "double"; }
};

// A structure that an expression names.
struct Named {
  std::string text;
  int type = 0;
};

// A number in a structure.
struct Place {
  std::string text;
  bool is_real = false;

  std::string Read() const { return is_real ? "(int)" + text : text; }
};

class Generator : RandomChoices {
 public:
  explicit Generator(uint64_t seed) : RandomChoices(seed) { program_.seed = seed; }

  StructuredProgram Make() {
    std::string& text = program_.text;
    program_.globals = {"g0", "g1", "g2", "g3"};
    members_[kTrap] = {
        {"acc", "double"}, {"dec", "double"}, {"velStart", "double"}, {"smoothTime", "short"}};
    members_[kPid] = {{"kp", "double"},
                      {"ki", "double"},
                      {"kd", "double"},
                      {"kvff", "double"},
                      {"kaff", "double"},
                      {"integralLimit", "long"},
                      {"derivativeLimit", "long"},
                      {"limit", "short"}};
    text += Definition(kPair) + Definition(kOuter);
    text += fmt::format("int g0, g1 = 5, g2, g3;\nstruct pair s0 = {0}, s1;\n", Values(kPair));
    text += fmt::format("struct outer w = {};\nstruct pair a[3] = {{{}, [2] = {}}};\n",
                        Values(kOuter), Values(kPair), Values(kPair));
    text += fmt::format("TTrapPrm h = {}, c[3] = {{{}, {}}};\nTPid e[3];\n", Values(kTrap),
                        Values(kTrap), Values(kTrap));
    globals_ = {{"s0", kPair}, {"s1", kPair},   {"w", kOuter}, {"a[*]", kPair},
                {"h", kTrap},  {"c[*]", kTrap}, {"e[*]", kPid}};
    structures_ = globals_;
    for (const int type : {kTrap, kPid, kPair, kOuter}) text += Digest(type);
    for (int type = 0; type < kTypes; ++type) text += ByReference(type) + ByValue(type);
    structures_ = globals_;
    for (const char* const name : {"l", "m[*]"}) structures_.push_back({name, kPair});
    structures_.push_back({"k", kOuter});
    structures_.push_back({"o[*]", kTrap});
    calls_ = true;
    text += fmt::format(
        "int f() {{\n  int x = 1, y = 2, z = 3;\n  struct pair l = {}, m[3] = {{{}, s1, l}};\n"
        "  struct outer k = {};\n  TTrapPrm o[3] = {{h, {}}};\n",
        Values(kPair), Values(kPair), Chance(50) ? "w" : Values(kOuter), Values(kTrap));
    for (int i = Between(4, 7); i > 0; --i) text += Statement(2, "  ");
    text += "  g3 += d0(&s0) + d0(&s1) * 3 + d2(&h);\n  g2 ^= d1(&w) - d1(&k);\n";
    text +=
        "  for (x = 0; x < 3; x++) {\n    g1 = g1 * 5 + d0(&a[x]) - d0(m + x);\n"
        "    g0 = g0 * 5 + d2(c + x) - d2(&o[x]) + d3(e + x) * 7;\n  }\n";
    text += "  return d0(&l) ^ y ^ z;\n}\n";
    return std::move(program_);
  }

 private:
  // The first structure has numbers, arrays of them and perhaps one of the card; the other one
  // such structures, too.
  std::string Definition(int type) {
    std::string text = fmt::format("{} {{\n", kNames[type]);
    const int count = Between(2, 3);
    for (int i = 0; i < count; ++i) {
      Member member;
      member.name = fmt::format("p{}", i);
      member.words = Pick({"int", "int", "short", "unsigned char"});
      if (type == kOuter && (i == 0 || Chance(30))) member.type = Chance(60) ? kPair : kTrap;
      if (type == kPair && i == 1 && Chance(70)) member.type = Chance(70) ? kTrap : kPid;
      if (member.type != kNumber) member.words = kNames[member.type];
      if (Chance(40)) member.size = Between(1, member.type == kNumber ? 7 : 2);
      text += fmt::format("  {} {}", member.words, member.name);
      text += member.size > 0 ? fmt::format("[{}];\n", member.size) : ";\n";
      members_[type].push_back(member);
    }
    return text + "};\n";
  }

  // The sum of all members.
  std::string Digest(int type) const {
    std::string text =
        fmt::format("static int d{}(const {} *p) {{\n  int s = 1;\n", type, kNames[type]);
    for (const Member& member : members_[type]) {
      const std::string term =
          member.type == kNumber ? "{}p->{}{}" : fmt::format("d{}({{}}p->{{}}{{}})", member.type);
      const char* const address = member.type != kNumber ? "&" : member.IsReal() ? "(int)" : "";
      if (member.size == 0) {
        text +=
            "  s = s * 7 + " + fmt::format(fmt::runtime(term), address, member.name, "") + ";\n";
      } else {
        text += fmt::format("  for (int i = 0; i < {}; i++) s = s * 3 + ", member.size) +
                fmt::format(fmt::runtime(term), address, member.name, "[i]") + ";\n";
      }
    }
    return text + "  return s;\n}\n";
  }

  // Values in braces: in order, some with inner braces, some with designators, some left out.
  std::string Values(int type) {
    std::string text;
    for (const Member& member : members_[type]) {
      if (Chance(20)) break;
      if (!text.empty()) text += ", ";
      if (Chance(20)) text += fmt::format(".{} = ", member.name);
      const int size = member.size > 0 ? member.size : 1;
      const bool braces = member.type != kNumber || Chance(50) || text.ends_with("= ");
      std::string values;
      for (int i = 0; i < size; ++i) {
        if (i > 0) values += ", ";
        if (member.type == kNumber) {
          values += std::to_string(Between(-9, 300));
        } else {
          values += Values(member.type);
        }
      }
      text += braces && member.size > 0 ? fmt::format("{{{}}}", values) : values;
    }
    return text.empty() ? "{0}" : fmt::format("{{{}}}", text);
  }

  std::string Index(int size) {
    if (Chance(40)) return std::to_string(Between(0, size - 1));
    return fmt::format("({} & 7) % {}", Pick({"x", "y"}), size);
  }

  // A structure that can be assigned, or one in it.
  Named Structure() {
    Named named =
        structures_[static_cast<size_t>(Between(0, static_cast<int>(structures_.size()) - 1))];
    const size_t star = named.text.find('*');
    if (star != std::string::npos && named.text[star - 1] == '[') {
      named.text.replace(star, 1, Index(3));
    }
    while (Chance(60)) {
      std::vector<const Member*> inner;
      for (const Member& member : members_[named.type]) {
        if (member.type != kNumber) inner.push_back(&member);
      }
      if (inner.empty()) break;
      const Member& member =
          *inner[static_cast<size_t>(Between(0, static_cast<int>(inner.size()) - 1))];
      named.text += "." + member.name;
      if (member.size > 0) named.text += fmt::format("[{}]", Index(member.size));
      named.type = member.type;
    }
    return named;
  }

  Named Structure(int type) {
    Named named = Structure();
    while (named.type != type) named = Structure();
    return named;
  }

  Place Number() {
    const Named named = Structure();
    std::string text = named.text;
    bool is_real = false;
    for (int type = named.type; type != kNumber;) {
      const std::vector<Member>& members = members_[type];
      const Member& member =
          members[static_cast<size_t>(Between(0, static_cast<int>(members.size()) - 1))];
      text = text == "(*p)" && Chance(70) ? "p->" : text + ".";
      text += member.name;
      if (member.size > 0) text += fmt::format("[{}]", Index(member.size));
      type = member.type;
      is_real = member.IsReal();
    }
    return {text, is_real};
  }

  // `place op value;`
  std::string Assignment(std::initializer_list<std::string_view> operators, int depth) {
    const Place place = Number();
    if (!place.is_real) {
      return fmt::format("{} {} {};\n", place.text, Pick(operators), Value(depth));
    }
    return fmt::format("{} {} {} & 1023;\n", place.text, Pick({"=", "+=", "-="}), Value(depth));
  }

  // Without effects.
  std::string Value(int depth) {
    if (depth <= 0 || Chance(25)) {
      switch (Between(0, 4)) {
        case 0:
          return std::to_string(Between(-3, 99));
        case 1:
          return Pick({"x", "y", "g0", "g1"});
        default:
          return Number().Read();
      }
    }
    if (Chance(20)) {
      return fmt::format("({} ? {} : {})", Value(depth - 1), Value(depth - 1), Value(depth - 1));
    }
    return fmt::format("({} {} {})", Value(depth - 1), Pick({"+", "-", "*", "&", "^", "<", "&&"}),
                       Value(depth - 1));
  }

  // A value that is a structure, without effects.
  std::string Source(int type, int depth) {
    switch (Between(0, 3)) {
      case 0:
        if (depth <= 0) break;
        return fmt::format("({} ? {} : {})", Value(1), Source(type, depth - 1),
                           Source(type, depth - 1));
      case 1:
        if (!calls_ || depth <= 0) break;
        return fmt::format("v{}({}, {})", type, Source(type, depth - 1), Value(1));
      default:
        break;
    }
    return Structure(type).text;
  }

  std::string Statement(int depth, const std::string& indent) {
    const std::string inner = indent + "  ";
    if (depth > 0 && Chance(25)) {
      return fmt::format("{0}if ({1}) {{\n{2}{3}{0}}} else {{\n{4}{0}}}\n", indent, Value(2),
                         Statement(depth - 1, inner), Statement(0, inner), Statement(0, inner));
    }
    if (depth > 0 && Chance(25)) {
      return fmt::format("{0}for (int i = 0; i < {1}; i++) {{\n{2}{0}  y += i;\n{0}}}\n", indent,
                         Between(1, 3), Statement(depth - 1, inner));
    }
    if (Chance(20)) return indent + Command();
    const Named named = Structure();
    switch (Between(0, calls_ ? 6 : 3)) {
      case 0:
      case 1:
        return indent + Assignment({"=", "+=", "^="}, 2);
      case 2:
        return fmt::format("{}{}{};\n", indent, Number().text, Pick({"++", "--"}));
      case 3:
        return fmt::format("{}{} = {};\n", indent, named.text, Source(named.type, 1));
      case 4:
        return fmt::format("{}x = r{}(&{}, {}, {});\n", indent, named.type, named.text,
                           Structure(named.type).text, Value(1));
      case 5:
        return fmt::format("{}z += (int)v{}({}, {}){};\n", indent, named.type,
                           Source(named.type, 1), Value(1), First(named.type));
      default:
        if (Chance(50)) {
          return fmt::format("{}y = r0({}, {}, x);\n", indent, Pick({"a + 1", "&a[x & 1]", "a"}),
                             Source(kPair, 1));
        }
        return fmt::format("{}y = r2({}, {}, x);\n", indent, Pick({"c + 1", "&o[x & 1]", "c"}),
                           Source(kTrap, 1));
    }
  }

  // One that keeps a structure, or reads it back; it fails unless the axis is from 1 to 4. A
  // constant that is no axis would be refused.
  std::string Command() {
    const Named named = Structure(Chance(70) ? kTrap : kPid);
    return fmt::format("GT_{}{}({}, {}&{});\n", Pick({"Set", "Get"}),
                       named.type == kTrap ? "TrapPrm" : "Pid",
                       Pick({"1", "3", "4", "6", "g0 & 7", "g1 & 7", "(x & 3) + 1", "(y & 3) + 1"}),
                       named.type == kTrap ? "" : "1, ", named.text);
  }

  // What leads from a structure to its first number.
  std::string First(int type) const {
    const Member& member = members_[type].front();
    return "." + member.name + (member.size > 0 ? "[0]" : "") +
           (member.type == kNumber ? "" : First(member.type));
  }

  std::string ByReference(int type) {
    structures_ = globals_;
    for (int i = 0; i < 3; ++i) structures_.push_back({"(*p)", type});
    structures_.push_back({"b", type});
    std::string text = fmt::format("static int r{0}({1} *p, {1} b, int x) {{\n  int y = x + 1;\n",
                                   type, kNames[type]);
    for (int i = Between(1, 3); i > 0; --i) text += Statement(1, "  ");
    if (Chance(30)) text += fmt::format("  if ({}) return {};\n", Value(1), Value(1));
    return text + fmt::format("  return {} + y;\n}}\n", Value(2));
  }

  // It changes nothing but its parameter.
  std::string ByValue(int type) {
    structures_ = {{"b", type}};
    std::string text =
        fmt::format("static {0} v{1}({0} b, int x) {{\n  int y = x;\n", kNames[type], type);
    if (Chance(30)) {
      text += fmt::format("  {} old = b;\n", kNames[type]);
      structures_.push_back({"old", type});
    }
    for (int i = Between(1, 2); i > 0; --i) {
      text += "  " + Assignment({"=", "-="}, 1);
    }
    return text + "  return b;\n}\n";
  }

  StructuredProgram program_;
  std::vector<Member> members_[kTypes];
  std::vector<Named> globals_;
  std::vector<Named> structures_;  // that can be named
  bool calls_ = false;
};

}  // namespace

StructuredProgram MakeStructProgram(uint64_t seed) { return Generator(seed).Make(); }

}  // namespace oncard::differential
