// Internal to gtcalls: how a command is written, and the lists of all commands. A command is one
// function; its arguments have passed the catalogue's ranges and NULL checks before it is called.
// It checks the card's state, then acts; a refused command changes nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gtcalls/card.h"
#include "vm/object.h"

namespace oncard::gtcalls {

/// One command and its function.
struct CommandEntry {
  std::string_view name;
  CommandFunction function = nullptr;
};

/// The commands of each file of this folder.
std::span<const CommandEntry> ThreadCommands();
std::span<const CommandEntry> VariableCommands();
std::span<const CommandEntry> TimeCommands();
std::span<const CommandEntry> DigitalIoCommands();
std::span<const CommandEntry> UserVariableCommands();
std::span<const CommandEntry> AnalogCommands();
std::span<const CommandEntry> ExtensionCommands();
std::span<const CommandEntry> EncoderCommands();
std::span<const CommandEntry> ServoCommands();
std::span<const CommandEntry> ConfigCommands();
std::span<const CommandEntry> PlcCommands();
std::span<const CommandEntry> PlcWordCommands();
std::span<const CommandEntry> AxisCommands();
std::span<const CommandEntry> PositionCommands();
std::span<const CommandEntry> TrapCommands();
std::span<const CommandEntry> GearCommands();
std::span<const CommandEntry> FollowCommands();
std::span<const CommandEntry> PtCommands();
std::span<const CommandEntry> PvtCommands();
std::span<const CommandEntry> CrdCommands();
std::span<const CommandEntry> SegmentCommands();
std::span<const CommandEntry> BufferCommands();
std::span<const CommandEntry> CaptureCommands();
std::span<const CommandEntry> HomeCommands();
std::span<const CommandEntry> CompareCommands();
std::span<const CommandEntry> CompensationCommands();
std::span<const CommandEntry> GantryCommands();
std::span<const CommandEntry> MramCommands();

/// All of them.
std::vector<CommandEntry> AllCommands();

/// True if the thread is in the middle of its function, or will be started again by its period.
bool IsActive(const vm::ThreadState& thread);

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

}  // namespace oncard::gtcalls
