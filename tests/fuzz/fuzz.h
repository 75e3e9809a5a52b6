// Shared by the fuzz targets. A target takes arbitrary bytes and must neither crash nor hang, nor
// violate its guarantees about the input; FUZZ_CHECK reports a violated guarantee.
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
void FuzzStructured(std::string_view bytes);
void FuzzObject(std::string_view bytes);
void FuzzDisassembler(std::string_view bytes);
void FuzzScenario(std::string_view bytes);
void FuzzSchedule(std::string_view bytes);
void FuzzSearch(std::string_view bytes);
void FuzzEni(std::string_view bytes);
void FuzzConfig(std::string_view bytes);
void FuzzRequirement(std::string_view bytes);
/// The record of a host's calls, which are repeated.
void FuzzCalls(std::string_view bytes);
/// Requests of the session protocol, one a line.
void FuzzSession(std::string_view bytes);
/// Calls commands, from one thread of a host or from 32.
void FuzzCommands(std::string_view bytes);
void FuzzCommandsOfThreads(std::string_view bytes);
/// Calls commands of a card of any family, one that the input chooses.
void FuzzFamilies(std::string_view input);

/// Mutates a search file as a JSON document and updates its checksum. Returns the new size.
size_t MutateSearch(uint8_t* data, size_t size, size_t max_size, unsigned seed);

/// The commands' shapes for the verifier and the disassembler.
const vm::CommandTable& Shapes();
/// A small program with two threads that share variables. The seeds' schedules and search files are
/// for this program (seeds/race.c).
const vm::Object& SeedProgram();
/// Runs every function of a program on a separate thread for a few milliseconds of virtual time.
void RunBriefly(const vm::Object& object);

}  // namespace oncard::fuzz
