#include "vm/object_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "tests/vm/object_samples.h"

namespace oncard::vm {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

// The vendor's object of example 10-1, word by word.
constexpr uint16_t kVendorSum[] = {
    0x0001, 0x0001, 0x0007,                                                  //
    0x0005, 0x5041, 0x0001, 0x0000, 0x0001, 0x0002,                          // i = begin
    0x0003, 0x000A, 0x0001, 0x0001,                                          //
    0x0006, 0x5040, 0x000B, 0x0002, 0x0001, 0x0001, 0x0003,                  // cc = i > end
    0x0004, 0x0016, 0x0001, 0x0001, 0x0001,                                  //
    0x0003, 0x5080, 0x0003, 0x0004, 0x0002, 0x0001, 0x0001,                  // if(cc) goto lbl_end
    0x0006, 0x5040, 0x0001, 0x0000, 0x0002, 0x0001, 0x0000,                  // sum = sum + i
    0x0004, 0x0016, 0x0003, 0x0001, 0x0003,                                  //
    0x0008, 0x5040, 0x0001, 0x0002, 0x0001, 0x0000, 0x0000, 0x0001, 0x0002,  // i = i + 1
    0x0003, 0x0012, 0x0001, 0x0001,                                          //
    0x0003, 0x5080, 0x0001, 0xFFFC, 0x0001, 0x0000,                          // goto lbl_loop
    0x0003, 0x5081, 0x0001, 0x0000, 0x0002, 0x0002, 0x0003,                  // return sum
};

std::string Bytes(std::span<const uint16_t> words) {
  std::string bytes;
  for (const uint16_t word : words) {
    bytes += static_cast<char>(word % 256);
    bytes += static_cast<char>(word / 256);
  }
  return bytes;
}

TEST(ObjectWriterTest, VendorBinIsReproducedByteForByte) {
  const ObjectFiles files = WriteObject(SumObject(), true);
  EXPECT_EQ(files.bin.size(), 140u);
  EXPECT_EQ(files.bin, Bytes(kVendorSum));
}

TEST(ObjectWriterTest, VendorIniIsReproducedByteForByte) {
  const ObjectFiles files = WriteObject(SumObject(), true);
  EXPECT_EQ(files.ini.size(), 129u);
  EXPECT_EQ(files.ini,
            "[function]\nadd=1,sum.c,1\n[global]\nsum=0,1\n"
            "[add.line]\n0=13\n1=15\n2=16\n3=17\n4=18\n5=19\n6=21\n"
            "[add.var]\nbegin=0,1\nend=1,1\ni=2,1\ncc=3,1\n");
}

TEST(ObjectWriterTest, OwnSectionFollowsTheVendorsWithFormatAndChecksum) {
  const ObjectFiles vendor = WriteObject(SumObject(), true);
  const ObjectFiles own = WriteObject(SumObject(), false);
  EXPECT_EQ(own.bin, vendor.bin);
  // The CRC-32 of the 140 bytes above, by Python's zlib.crc32.
  EXPECT_EQ(own.ini, vendor.ini + "[oncard]\nformat=1\ndouble=32.16\nbin_crc32=e72a6151\n");
}

TEST(ObjectWriterTest, NamesOfCFollowUnlessTheFilesAreAVendors) {
  Object object = ArrayObject();
  object.globals[1].written = "table[2][4]";
  object.functions[0].variables[0].written = "axis.i";
  object.functions[0].variables[1].written = "axis.list[5]";
  EXPECT_THAT(WriteObject(object, false).ini, EndsWith("\n[names]\ntable=table[2][4]\n"
                                                       "[work.names]\ni=axis.i\na=axis.list[5]\n"));
  EXPECT_EQ(WriteObject(object, true).ini, WriteObject(ArrayObject(), true).ini);
}

TEST(ObjectWriterTest, NarrowDoublesAreNamed) {
  EXPECT_THAT(WriteObject(StructureObject(), false).ini, HasSubstr("\ndouble=16.16\n"));
}

TEST(ObjectWriterTest, SectionsOfFunctionsStandInOrderOfDefinition) {
  EXPECT_EQ(WriteObject(ArrayObject(), true).ini,
            "[function]\nwork=1,array.c,0\nnothing=2,array.c,1\n"
            "[global]\nn=0,1\ntable[8]=1,1\npos[4]=9,2\n"
            "[work.line]\n0=5\n1=6\n2=7\n3=8\n4=9\n5=10\n6=11\n7=12\n8=13\n"
            "[work.var]\ni=0,1\na[5]=1,1\n"
            "[nothing.line]\n[nothing.var]\n");
}

TEST(ObjectWriterTest, MembersAreSymbolsOfTheirOwn) {
  EXPECT_THAT(WriteObject(StructureObject(), true).ini,
              HasSubstr("[move.var]\ntrap.acc=0,2\ntrap.dec=1,2\ntrap.velStart=2,2\n"
                        "trap.smoothTime=3,1\nless=4,1\n"));
}

TEST(ObjectWriterTest, EmptyFunctionIsItsHeader) {
  Object object = ArrayObject();
  object.functions.erase(object.functions.begin());
  EXPECT_EQ(WriteObject(object, true).bin, Bytes(std::to_array<uint16_t>({1, 1, 0})));
}

TEST(ObjectWriterTest, EmptyProgramHasEmptySections) {
  const ObjectFiles files = WriteObject(Object(), true);
  EXPECT_EQ(files.bin, "");
  EXPECT_EQ(files.ini, "[function]\n[global]\n");
}

TEST(ObjectWriterTest, ChecksumIsTheCommonCrc32) {
  // Check value of CRC-32/ISO-HDLC.
  EXPECT_EQ(BinChecksum("123456789"), 0xCBF43926u);
  EXPECT_EQ(BinChecksum(""), 0u);
  // By Python's zlib.crc32.
  std::string all_bytes;
  for (int byte = 0; byte < 256; ++byte) all_bytes.push_back(static_cast<char>(byte));
  EXPECT_EQ(BinChecksum(all_bytes), 0x29058C73u);
}

}  // namespace
}  // namespace oncard::vm
