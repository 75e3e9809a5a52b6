// What the fuzz targets share. A target takes bytes of any kind and must neither crash, hang, nor
// break what it promises about its input; a broken promise is reported by FUZZ_CHECK.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "vm/command_table.h"
#include "vm/object.h"

#define FUZZ_CHECK(condition)                                                            \
  do {                                                                                   \
    if (!(condition)) {                                                                  \
      std::fprintf(stderr, "%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                      \
    }                                                                                    \
  } while (false)

namespace oncard::fuzz {

void FuzzSource(std::string_view bytes);
void FuzzObject(std::string_view bytes);
void FuzzDisassembler(std::string_view bytes);
void FuzzScenario(std::string_view bytes);
void FuzzSchedule(std::string_view bytes);
void FuzzSearch(std::string_view bytes);
void FuzzConfig(std::string_view bytes);
void FuzzRequirement(std::string_view bytes);
/// Calls of commands: from one thread of a host, or from 32.
void FuzzCommands(std::string_view bytes);
void FuzzCommandsOfThreads(std::string_view bytes);

/// Changes a search file as a document, keeps it JSON and its checksum right. Gives the new size.
size_t MutateSearch(uint8_t* data, size_t size, size_t max_size, unsigned seed);

/// The commands' shapes, as the verifier and the disassembler want them.
const vm::CommandTable& Shapes();
/// A small program with two threads that share variables, the one that schedules and search files
/// of the seeds belong to (seeds/race.c).
const vm::Object& SeedProgram();
/// Runs every function of a program on a thread of its own, for a few milliseconds of its time.
void RunBriefly(const vm::Object& object);

}  // namespace oncard::fuzz
