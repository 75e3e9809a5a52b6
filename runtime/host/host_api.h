// The way from a C entry point of libgts to a card. The entry points are generated from the
// catalogue (one line each: `return CallFromHost(card, number, arguments...)`); everything they
// have in common is behind CallFromHost(): which card, is it open, its clock, its arguments, the
// command, the outputs, the call log.
//
// Thread-safe: commands from several host threads are serialised per card, cards do not wait for
// each other. A call holds one card's lock and nothing else while it runs.
// Tested by tests/runtime/host_api_test.cc and host_threads_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

namespace oncard::runtime {

/// Cards of one process, numbered from 0.
inline constexpr int kCardCount = 16;

/// The card of the single-card header: the one GT_SetCardNo chose, 0 at first. No `short` that a
/// host passes as a card number equals it.
inline constexpr int kSelectedCard = 0x10000;

/// The lowest memory of a process is never mapped: what points there is a number that a host passes
/// where a pointer belongs.
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
  void* pointer = nullptr;  ///< kPointer; const was the entry point's promise to its caller
};

/// Wraps an argument of any type that the interface uses.
template <typename T>
HostArgument ToHostArgument(T argument) {
  HostArgument result;
  if constexpr (std::is_pointer_v<T>) {
    result.kind = HostArgument::Kind::kPointer;
    result.pointer = const_cast<void*>(static_cast<const void*>(argument));
  } else if constexpr (std::is_floating_point_v<T>) {
    result.kind = HostArgument::Kind::kReal;
    result.real = argument;
  } else {
    static_assert(std::is_integral_v<T>);
    result.integer = static_cast<int64_t>(argument);
  }
  return result;
}

/// Executes a command for the host and gives its code: 7 when `card` is neither kSelectedCard nor
/// in [0, 15], -1 when that card is not open, otherwise the command's own.
int16_t CallCard(int card, uint16_t number, std::span<const HostArgument> arguments);

/// What an entry point calls, with its own parameters in the order of the catalogue.
template <typename... Args>
short CallFromHost(int card, uint16_t number, Args... arguments) {
  const std::array<HostArgument, sizeof...(Args)> wrapped = {ToHostArgument(arguments)...};
  return CallCard(card, number, wrapped);
}

}  // namespace oncard::runtime
