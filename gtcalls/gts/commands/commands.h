// Internal to gtcalls: how a command is written, and the list of all commands. A command is one
// function with its name in the catalogue; its arguments have passed the catalogue's ranges and
// NULL checks before it is called. It checks the card's state, then acts; a refused command changes
// nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gtcalls/card.h"
#include "vm/object.h"

namespace oncard::gtcalls::gts {

/// The commands: one function for each row of the catalogue, except those of the host library and
/// those of unsupported.def. The files of this folder define them; the linker reports a missing
/// one.
#define COMMAND(number, name, ...) int16_t name(Call& call);
#include "gtcalls/gts/catalogue.def"

/// Why a thread is not in the state that a command needs: its state, and what to call first.
Message DescribeThread(int thread, const vm::ThreadState& state);

/// Why a data page cannot be used: a page belongs to at most one thread.
Message DescribeTakenPage(int page);

/// Refuses a command that only makes sense inside a motion program.
int16_t RefuseHost(Call& call);

/// Milliseconds as profile cycles, rounded up.
int64_t CyclesFromMs(const Call& call, int64_t milliseconds);

/// The low 32 bits of a bit word, whether signed or unsigned.
inline uint32_t BitWord(double value) { return static_cast<uint32_t>(static_cast<int64_t>(value)); }

/// A counter as the card's 32-bit unsigned long shows it.
inline double UnsignedLong(int64_t count) {
  return static_cast<double>(static_cast<uint32_t>(count));
}

/// The slot of the program's variable that `info`, the cells of a TVarInfo, describes on a page
/// (-1: the globals), if it can hold `value`. Empty otherwise, with the reason recorded: refuse
/// with 7.
std::optional<vm::SlotAddress> FindVariable(Call& call, int page, std::span<const double> info,
                                            double value);

/// True for a program that was downloaded by words: it declares no variables.
bool HasNoSymbols(const vm::Image& image);

/// The data type of a slot according to the symbols; empty when nothing is declared there.
std::optional<vm::DataType> DeclaredType(const std::vector<vm::Symbol>& symbols, int id);

/// Makes the functions received by words the program when `function_id` is one of them and they
/// have changed since. 0, or the code with which to refuse GT_Bind; then nothing has changed.
int16_t LinkPendingWords(Call& call, int function_id);

}  // namespace oncard::gtcalls::gts
