// Indices are made of local ints, which no call changes, and a call that changes what others read
// stands alone on the right of an assignment, so that no order of operands matters.
#include "struct_program.h"

#include <fmt/core.h>

#include <string>
#include <vector>

#include "random_choices.h"

namespace oncard::differential {
namespace {

constexpr int kTypes = 2;
constexpr int kNumber = -1;  // the type of a member that is no structure

struct Member {
  std::string name;
  std::string words;  // of its type
  int type = kNumber;
  int size = 0;  // of an array
};

// A structure that an expression names.
struct Named {
  std::string text;
  int type = 0;
};

class Generator : RandomChoices {
 public:
  explicit Generator(uint64_t seed) : RandomChoices(seed) { program_.seed = seed; }

  StructuredProgram Make() {
    std::string& text = program_.text;
    program_.globals = {"g0", "g1", "g2", "g3"};
    for (int type = 0; type < kTypes; ++type) text += Definition(type);
    text += fmt::format("int g0, g1 = 5, g2, g3;\nstruct pair s0 = {0}, s1;\n", Values(0));
    text += fmt::format("struct outer w = {};\nstruct pair a[3] = {{{}, [2] = {}}};\n", Values(1),
                        Values(0), Values(0));
    globals_ = {{"s0", 0}, {"s1", 0}, {"w", 1}, {"a[*]", 0}};
    structures_ = globals_;
    for (int type = 0; type < kTypes; ++type) text += Digest(type);
    for (int type = 0; type < kTypes; ++type) text += ByReference(type) + ByValue(type);
    structures_ = globals_;
    for (const char* const name : {"l", "m[*]"}) structures_.push_back({name, 0});
    structures_.push_back({"k", 1});
    calls_ = true;
    text += fmt::format(
        "int f() {{\n  int x = 1, y = 2, z = 3;\n  struct pair l = {}, m[3] = {{{}, s1, l}};\n"
        "  struct outer k = {};\n",
        Values(0), Values(0), Chance(50) ? "w" : Values(1));
    for (int i = Between(4, 7); i > 0; --i) text += Statement(2, "  ");
    text += "  g3 += d0(&s0) + d0(&s1) * 3;\n  g2 ^= d1(&w) - d1(&k);\n";
    text += "  for (x = 0; x < 3; x++) g1 = g1 * 5 + d0(&a[x]) - d0(m + x);\n";
    text += "  return d0(&l) ^ y ^ z;\n}\n";
    return std::move(program_);
  }

 private:
  static std::string Name(int type) { return type == 0 ? "pair" : "outer"; }

  // The first structure has numbers and arrays of them, the other one such structures, too.
  std::string Definition(int type) {
    std::string text = fmt::format("struct {} {{\n", Name(type));
    const int count = Between(2, 3);
    for (int i = 0; i < count; ++i) {
      Member member;
      member.name = fmt::format("p{}", i);
      member.words = Pick({"int", "int", "short", "unsigned char"});
      if (type > 0 && (i == 0 || Chance(30))) {
        member.type = 0;
        member.words = "struct pair";
      }
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
        fmt::format("static int d{}(const struct {} *p) {{\n  int s = 1;\n", type, Name(type));
    for (const Member& member : members_[type]) {
      const std::string term = member.type == kNumber ? "{}p->{}{}" : "d0({}p->{}{})";
      const char* const address = member.type == kNumber ? "" : "&";
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

  // A structure that can be assigned.
  Named Structure() {
    Named named =
        structures_[static_cast<size_t>(Between(0, static_cast<int>(structures_.size()) - 1))];
    const size_t star = named.text.find('*');
    if (star != std::string::npos && named.text[star - 1] == '[') {
      named.text.replace(star, 1, Index(3));
    }
    while (named.type > 0 && Chance(60)) {
      for (const Member& member : members_[named.type]) {
        if (member.type == kNumber || (Chance(50) && &member != &members_[named.type].front())) {
          continue;
        }
        named.text += "." + member.name;
        if (member.size > 0) named.text += fmt::format("[{}]", Index(member.size));
        named.type = member.type;
        break;
      }
    }
    return named;
  }

  Named Structure(int type) {
    Named named = Structure();
    while (named.type != type) named = Structure();
    return named;
  }

  // A number in a structure.
  std::string Number() {
    const Named named = Structure();
    std::string text = named.text;
    for (int type = named.type; type != kNumber;) {
      const std::vector<Member>& members = members_[type];
      const Member& member =
          members[static_cast<size_t>(Between(0, static_cast<int>(members.size()) - 1))];
      text = text == "(*p)" && Chance(70) ? "p->" : text + ".";
      text += member.name;
      if (member.size > 0) text += fmt::format("[{}]", Index(member.size));
      type = member.type;
    }
    return text;
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
          return Number();
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
    const Named named = Structure();
    switch (Between(0, calls_ ? 6 : 3)) {
      case 0:
      case 1:
        return fmt::format("{}{} {} {};\n", indent, Number(), Pick({"=", "+=", "^="}), Value(2));
      case 2:
        return fmt::format("{}{}{};\n", indent, Number(), Pick({"++", "--"}));
      case 3:
        return fmt::format("{}{} = {};\n", indent, named.text, Source(named.type, 1));
      case 4:
        return fmt::format("{}x = r{}(&{}, {}, {});\n", indent, named.type, named.text,
                           Structure(named.type).text, Value(1));
      case 5:
        return fmt::format("{}z += v{}({}, {}).p0{};\n", indent, named.type, Source(named.type, 1),
                           Value(1), First(named.type));
      default:
        return fmt::format("{}y = r0({}, {}, x);\n", indent, Pick({"a + 1", "&a[x & 1]", "a"}),
                           Source(0, 1));
    }
  }

  // What leads from the first member of a structure to a number.
  std::string First(int type) const {
    const Member& member = members_[type].front();
    return (member.size > 0 ? "[0]" : "") +
           (member.type == kNumber ? "" : ".p0" + First(member.type));
  }

  std::string ByReference(int type) {
    structures_ = globals_;
    for (int i = 0; i < 3; ++i) structures_.push_back({"(*p)", type});
    structures_.push_back({"b", type});
    std::string text =
        fmt::format("static int r{0}(struct {1} *p, struct {1} b, int x) {{\n  int y = x + 1;\n",
                    type, Name(type));
    for (int i = Between(1, 3); i > 0; --i) text += Statement(1, "  ");
    if (Chance(30)) text += fmt::format("  if ({}) return {};\n", Value(1), Value(1));
    return text + fmt::format("  return {} + y;\n}}\n", Value(2));
  }

  // It changes nothing but its parameter.
  std::string ByValue(int type) {
    structures_ = {{"b", type}};
    std::string text = fmt::format("static struct {0} v{1}(struct {0} b, int x) {{\n  int y = x;\n",
                                   Name(type), type);
    if (Chance(30)) {
      text += fmt::format("  struct {} old = b;\n", Name(type));
      structures_.push_back({"old", type});
    }
    for (int i = Between(1, 2); i > 0; --i) {
      text += fmt::format("  {} {} {};\n", Number(), Pick({"=", "-="}), Value(1));
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
