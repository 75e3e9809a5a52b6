// Damaged objects: for any bytes, reading and verifying end with an object or an error. With a
// checksum every change of the `.bin` is detected, and no change of the `.ini` changes code.

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/vm/object_samples.h"
#include "vm/disassembler.h"
#include "vm/object_reader.h"
#include "vm/object_writer.h"
#include "vm/verifier.h"

namespace oncard::vm {
namespace {

const std::vector<Object>& Samples() {
  static const std::vector<Object> samples = {SumObject(), ArrayObject(), StructureObject()};
  return samples;
}

bool SameCode(const Object& a, const Object& b) {
  if (a.functions.size() != b.functions.size()) return false;
  for (size_t i = 0; i < a.functions.size(); ++i) {
    if (a.functions[i].return_type != b.functions[i].return_type) return false;
    if (a.functions[i].instructions != b.functions[i].instructions) return false;
  }
  return true;
}

// Uses an accepted object like the rest of the program: lists it, writes it, measures its storage.
void Use(const Object& object, const ObjectFiles& files, bool verified) {
  const FakeCommands commands;
  EXPECT_FALSE(Disassemble(object, commands).empty());
  EXPECT_EQ(WriteObject(object, true).bin, files.bin);
  if (!verified) return;
  for (const Function& function : object.functions) {
    for (const Instruction& instruction : function.instructions) {
      for (const Operand& operand : instruction.operands) {
        if (const auto* variable = std::get_if<Variable>(&operand)) {
          EXPECT_GE(StorageExtent(object, function, *variable), 1);
        }
      }
    }
  }
}

enum class Outcome { kUnreadable, kRefused, kAccepted };

Outcome Load(const ObjectFiles& files, Object* object) {
  Result<Object> read = ReadObject(files);
  if (!read.ok()) {
    EXPECT_TRUE(read.error().code == 2008 || read.error().code == 7);
    EXPECT_FALSE(read.error().message.en.empty());
    return Outcome::kUnreadable;
  }
  *object = std::move(read).value();
  const Result<void> verified = Verify(*object, FakeCommands());
  if (!verified.ok()) {
    EXPECT_TRUE(verified.error().code == 2008 || verified.error().code == 7);
    EXPECT_FALSE(verified.error().message.en.empty());
  }
  Use(*object, files, verified.ok());
  return verified.ok() ? Outcome::kAccepted : Outcome::kRefused;
}

// Calls `check` for every single-byte change of `content`, which is unchanged afterwards.
template <typename Check>
void ForEachByteChange(std::string* content, const Check& check) {
  for (size_t i = 0; i < content->size(); ++i) {
    const char original = (*content)[i];
    for (int change = 1; change < 256; ++change) {
      (*content)[i] = static_cast<char>(original ^ change);
      check(i);
    }
    (*content)[i] = original;
  }
}

TEST(CorruptionTest, ChecksumCatchesEveryByteOfTheBin) {
  for (const Object& sample : Samples()) {
    ObjectFiles files = WriteObject(sample, false);
    Object read;
    ForEachByteChange(&files.bin, [&](size_t position) {
      EXPECT_EQ(Load(files, &read), Outcome::kUnreadable) << position;
    });
  }
}

TEST(CorruptionTest, NoByteOfTheIniChangesCode) {
  for (const Object& sample : Samples()) {
    ObjectFiles files = WriteObject(sample, false);
    Object read;
    ForEachByteChange(&files.ini, [&](size_t position) {
      if (Load(files, &read) != Outcome::kAccepted) return;
      EXPECT_TRUE(SameCode(read, sample)) << position;
      EXPECT_EQ(read.double_format, sample.double_format) << position;
    });
  }
}

TEST(CorruptionTest, EveryByteOfAVendorObjectMayBeDamaged) {
  for (const Object& sample : Samples()) {
    ObjectFiles files = WriteObject(sample, true);
    Object read;
    int accepted = 0;
    int refused = 0;
    const auto count = [&](size_t) {
      const Outcome outcome = Load(files, &read);
      accepted += outcome == Outcome::kAccepted ? 1 : 0;
      refused += outcome == Outcome::kRefused ? 1 : 0;
    };
    ForEachByteChange(&files.bin, count);
    ForEachByteChange(&files.ini, count);
    // Objects with other literals, operators and names are valid too; most other changes are not.
    EXPECT_GT(accepted, 0);
    EXPECT_GT(refused, 0);
  }
}

class Mutator {
 public:
  explicit Mutator(uint32_t seed) : random_(seed) {}

  size_t Below(size_t limit) { return random_() % limit; }

  // Inserts, deletes or changes bytes, or inserts a piece of `donor`.
  void Mutate(const std::string& donor, std::string* content) {
    const size_t position = Below(content->size() + 1);
    const size_t rest = content->size() - position;
    switch (Below(6)) {
      case 0:
        content->insert(position, 1, AnyByte());
        break;
      case 1:
        content->erase(position, 1 + Below(8));
        break;
      case 2:
        if (rest > 0) (*content)[position] = AnyByte();
        break;
      case 3:
        if (rest > 0)
          (*content)[position] = static_cast<char>((*content)[position] ^ 1 << Below(8));
        break;
      case 4: {
        const std::string piece = donor.substr(Below(donor.size() + 1), Below(24));
        content->replace(position, Below(2) * Below(24), piece);
        break;
      }
      default:
        // Whole words, so that the following records keep their alignment.
        content->replace(position & ~size_t{1}, 2 * Below(2),
                         {static_cast<char>(Below(20)), static_cast<char>(0)});
        break;
    }
  }

 private:
  char AnyByte() { return static_cast<char>(random_()); }

  std::mt19937 random_;
};

TEST(CorruptionTest, RandomDamageNeverPassesTheChecksum) {
  constexpr int kRounds = 60000;
  Mutator mutator(20240601);
  for (int round = 0; round < kRounds; ++round) {
    SCOPED_TRACE(round);
    const Object& sample = Samples()[mutator.Below(3)];
    const ObjectFiles original = WriteObject(sample, false);
    const ObjectFiles donor = WriteObject(Samples()[mutator.Below(3)], false);
    ObjectFiles files = original;
    for (size_t count = 1 + mutator.Below(4); count > 0; --count) {
      if (mutator.Below(2) == 0) {
        mutator.Mutate(donor.bin, &files.bin);
      } else {
        mutator.Mutate(donor.ini, &files.ini);
      }
    }
    Object read;
    if (Load(files, &read) != Outcome::kAccepted) continue;
    // The section [oncard] itself may disappear; the result is a vendor's object without a
    // checksum.
    if (files.ini.find("bin_crc32=") == std::string::npos) continue;
    ASSERT_EQ(files.bin, original.bin);
    ASSERT_TRUE(SameCode(read, sample));
  }
}

TEST(CorruptionTest, RandomDamageOfVendorObjectsIsSurvived) {
  constexpr int kRounds = 100000;
  Mutator mutator(20240602);
  for (int round = 0; round < kRounds; ++round) {
    SCOPED_TRACE(round);
    ObjectFiles files = WriteObject(Samples()[mutator.Below(3)], true);
    const ObjectFiles donor = WriteObject(Samples()[mutator.Below(3)], true);
    for (size_t count = 1 + mutator.Below(4); count > 0; --count) {
      if (mutator.Below(3) != 0) {
        mutator.Mutate(donor.bin, &files.bin);
      } else {
        mutator.Mutate(donor.ini, &files.ini);
      }
    }
    Object read;
    Load(files, &read);
    if (HasFatalFailure()) return;
  }
}

TEST(CorruptionTest, ArbitraryBytesAreSurvived) {
  constexpr int kRounds = 50000;
  std::mt19937 random(20240603);
  for (int round = 0; round < kRounds; ++round) {
    SCOPED_TRACE(round);
    ObjectFiles files;
    for (uint32_t size = random() % 64; size > 0; --size) {
      files.bin += static_cast<char>(random() % 4 == 0 ? random() : random() % 8);
    }
    constexpr std::string_view kIniBytes = "[]\n=,.01aa";
    files.ini = "[function]\n";
    for (uint32_t size = random() % 64; size > 0; --size) {
      files.ini += kIniBytes[random() % kIniBytes.size()];
    }
    Object read;
    Load(files, &read);
  }
}

}  // namespace
}  // namespace oncard::vm
