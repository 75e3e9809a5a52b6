// Connects a C entry point of a host library to a card. The entry points are generated from the
// catalogue (one line each: `return CallFromHost(card, number, arguments...)`); CallFromHost() does
// everything they have in common: it finds the card, checks that it is open, advances its clock,
// converts the arguments, executes the command, returns the outputs and writes the call log.
//
// Thread-safe: commands from several host threads are serialised per card; different cards do not
// wait for each other. A call holds only the lock of its card. Tested by
// tests/runtime/host_api_test.cc and host_threads_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

namespace oncard::runtime {

/// Cards of one process, numbered from 0.
inline constexpr int kCardCount = 16;

/// The card of functions without a card number, initially 0 (SelectCard()). No `short` that a
/// host passes as a card number has this value.
inline constexpr int kSelectedCard = 0x10000;

/// The lowest memory of a process is never mapped: an address below this is a number passed by
/// mistake in place of a pointer.
inline bool IsAddress(const void* pointer) {
  constexpr uintptr_t kPageSize = 4096;
  return reinterpret_cast<uintptr_t>(pointer) >= kPageSize;
}

/// One argument exactly as the host passed it.
struct HostArgument {
  enum class Kind : uint8_t { kInteger, kReal, kPointer };
  Kind kind = Kind::kInteger;
  int64_t integer = 0;      ///< kInteger; an unsigned long keeps its bits
  double real = 0;          ///< kReal
  void* pointer = nullptr;  ///< kPointer; the entry point's own parameter may be const
};

/// Wraps an argument of any type that the interface uses.
template <typename T>
HostArgument ToHostArgument(T argument) {
  HostArgument result;
  if constexpr (std::is_pointer_v<T>) {
    result.kind = HostArgument::Kind::kPointer;
    if constexpr (std::is_function_v<std::remove_pointer_t<T>>) {
      result.pointer = reinterpret_cast<void*>(argument);
    } else {
      result.pointer = const_cast<void*>(static_cast<const void*>(argument));
    }
  } else if constexpr (std::is_floating_point_v<T>) {
    result.kind = HostArgument::Kind::kReal;
    result.real = argument;
  } else {
    static_assert(std::is_integral_v<T> || std::is_enum_v<T>);
    result.integer = static_cast<int64_t>(argument);
  }
  return result;
}

/// Executes a command for the host and returns its code: 7 if `card` is neither kSelectedCard nor
/// in [0, 15], -1 if that card is not open, otherwise the command's own.
int16_t CallCard(int card, uint16_t number, std::span<const HostArgument> arguments);

/// Called by an entry point with its own parameters, in the order of the catalogue.
template <typename... Args>
short CallFromHost(int card, uint16_t number, Args... arguments) {
  const std::array<HostArgument, sizeof...(Args)> wrapped = {ToHostArgument(arguments)...};
  return CallCard(card, number, wrapped);
}

}  // namespace oncard::runtime
