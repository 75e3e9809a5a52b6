#include "runtime/host/marshal.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "gtcalls/card_elements.h"
#include "runtime/host/host_structures.h"
#include "runtime/host/host_system.h"
#include "vm/machine.h"

namespace oncard::runtime {
namespace {

using gtcalls::Command;
using gtcalls::Parameter;
using gtcalls::Passing;
using gtcalls::Scalar;

template <typename T>
double ReadElement(const void* host, size_t index) {
  return static_cast<double>(static_cast<const T*>(host)[index]);
}

template <typename T>
void WriteElement(void* host, size_t index, double value) {
  static_cast<T*>(host)[index] = FromCell<T>(value);
}

/// An element of a host's array of long, or of unsigned long as the same bits.
int64_t ReadLong(const void* host, size_t index) {
  if (LongSize() == sizeof(int32_t)) return static_cast<const int32_t*>(host)[index];
  return static_cast<const long*>(host)[index];
}

/// Writes it; `Long` is the compiler's type, `Narrow` the one with 32 bits.
template <typename Long, typename Narrow>
void WriteLong(void* host, size_t index, double value) {
  if (LongSize() == sizeof(Narrow)) return WriteElement<Narrow>(host, index, value);
  WriteElement<Long>(host, index, value);
}

/// One element of a host's array of scalars; empty for a long that does not fit 32 bits.
std::optional<double> ReadScalar(Scalar type, const void* host, size_t index) {
  switch (type) {
    case Scalar::kChar:
      return ReadElement<char>(host, index);
    case Scalar::kUnsignedChar:
      return ReadElement<unsigned char>(host, index);
    case Scalar::kShort:
      return ReadElement<short>(host, index);
    case Scalar::kUnsignedShort:
      return ReadElement<unsigned short>(host, index);
    case Scalar::kInt:
      return ReadElement<int>(host, index);
    case Scalar::kLong:
      return NarrowLong(ReadLong(host, index), false);
    case Scalar::kUnsignedLong:
      return NarrowLong(ReadLong(host, index), true);
    case Scalar::kDouble:
      break;
  }
  return static_cast<const double*>(host)[index];
}

void WriteScalar(Scalar type, void* host, size_t index, double value) {
  switch (type) {
    case Scalar::kChar:
      return WriteElement<char>(host, index, value);
    case Scalar::kUnsignedChar:
      return WriteElement<unsigned char>(host, index, value);
    case Scalar::kShort:
      return WriteElement<short>(host, index, value);
    case Scalar::kUnsignedShort:
      return WriteElement<unsigned short>(host, index, value);
    case Scalar::kInt:
      return WriteElement<int>(host, index, value);
    case Scalar::kLong:
      return WriteLong<long, int32_t>(host, index, value);
    case Scalar::kUnsignedLong:
      return WriteLong<unsigned long, uint32_t>(host, index, value);
    case Scalar::kDouble:
      break;
  }
  static_cast<double*>(host)[index] = value;
}

Error NotALong(const Parameter& parameter) {
  return MakeError(vm::kBadParameter, "parameter {} holds a value that does not fit 32 bits",
                   "参数 {} 中的值超出 32 位范围", parameter.name);
}

/// True for a word of bits, of which the card uses the lower 32. The bits above, of a host whose
/// `long` has 64 bits, are ignored: `mask = mask | 1` may have set them if the variable was never
/// initialised.
bool IsWordOfBits(const Parameter& parameter) {
  return parameter.unit == gtcalls::Unit::kMask || parameter.unit == gtcalls::Unit::kBits;
}

/// The value of a scalar argument; empty for a long that does not fit 32 bits.
std::optional<double> ReadValue(const Parameter& parameter, const HostArgument& host) {
  if (host.kind == HostArgument::Kind::kReal) return host.real;
  if (parameter.type != Scalar::kLong && parameter.type != Scalar::kUnsignedLong) {
    return static_cast<double>(host.integer);
  }
  const int64_t bits = IsWordOfBits(parameter) ? static_cast<int32_t>(host.integer) : host.integer;
  return NarrowLong(bits, parameter.type == Scalar::kUnsignedLong);
}

/// True if a command cannot have this pointer as its argument.
bool IsBadPointer(const Parameter& parameter, const void* pointer) {
  if (pointer == nullptr) return !parameter.nullable;
  if (parameter.passing == Passing::kHandle) return !CanBeHandle(pointer);
  return parameter.passing != Passing::kLent && !IsAddress(pointer);
}

Error BadPointer(const Parameter& parameter, const void* pointer) {
  if (pointer == nullptr) {
    return MakeError(vm::kBadParameter, "parameter {} is NULL; pass the address of a variable",
                     "参数 {} 为 NULL；应传入变量的地址", parameter.name);
  }
  return MakeError(
      vm::kBadParameter, "parameter {} is the number {}; pass the address of a variable",
      "参数 {} 为数值 {}；应传入变量的地址", parameter.name, reinterpret_cast<uintptr_t>(pointer));
}

Error BadCount(const Command& command, const Parameter& parameter, const MarshalledCall& call) {
  const auto index = static_cast<size_t>(parameter.count_parameter);
  const Parameter& counter = command.parameters[index];
  return MakeError(vm::kBadParameter, "parameter {} is {}; the range is {}",
                   "参数 {} 为 {}；取值范围为 {}", counter.name, call.arguments[index].value,
                   SpellRange(counter));
}

bool HasCells(const Parameter& parameter) {
  return parameter.passing == Passing::kInput || parameter.passing == Passing::kOutput ||
         parameter.passing == Passing::kHostMemory;
}

/// Calls `visit(index)` for each bit of `set`.
template <typename Visit>
void ForEachIn(uint32_t set, const Visit& visit) {
  for (; set != 0; set &= set - 1) visit(static_cast<size_t>(std::countr_zero(set)));
}

/// Calls `visit(address, cells)` for each structure of a host's array.
template <typename Visit>
void ForEachStructure(const Parameter& parameter, const vm::CommandArgument& argument,
                      const Visit& visit) {
  const size_t per_element = CellsPerElement(parameter);
  char* address = static_cast<char*>(argument.host);
  for (size_t cell = 0; cell < argument.cells.size(); cell += per_element) {
    visit(address, argument.cells.subspan(cell, per_element));
    address += StructureSize(*parameter.structure);
  }
}

/// Copies the values behind an input pointer to its cells.
Result<void> ReadCells(const Parameter& parameter, const vm::CommandArgument& argument) {
  if (parameter.structure != nullptr) {
    ForEachStructure(parameter, argument, [&](const char* host, std::span<double> cells) {
      StructureToCells(*parameter.structure, host, cells);
    });
    return {};
  }
  for (size_t i = 0; i < argument.cells.size(); ++i) {
    const auto value = ReadScalar(parameter.type, argument.host, i);
    if (!value.has_value()) return NotALong(parameter);
    argument.cells[i] = *value;
  }
  return {};
}

std::vector<void*> ArraysBehind(const Parameter& parameter, const vm::CommandArgument& argument) {
  std::vector<void*> arrays(CellsPerElement(parameter));
  ArraysOfHost(*parameter.structure, argument.host, arrays);
  return arrays;
}

/// Says in the first element of the cells which arrays there are.
void LookForArrays(const Parameter& parameter, const vm::CommandArgument& argument) {
  if (argument.cells.empty()) return;  // the card is not open
  const std::vector<void*> arrays = ArraysBehind(parameter, argument);
  for (size_t i = 0; i < arrays.size(); ++i) argument.cells[i] = IsAddress(arrays[i]) ? 1 : 0;
}

void FillArrays(const Parameter& parameter, const vm::CommandArgument& argument) {
  const std::vector<gtcalls::Scalar> types = ArraysOf(*parameter.structure);
  const std::vector<void*> arrays = ArraysBehind(parameter, argument);
  const size_t elements = argument.cells.size() / arrays.size();
  for (size_t i = 0; i < arrays.size(); ++i) {
    if (argument.cells[i] == 0) continue;
    for (size_t element = 1; element < elements; ++element) {
      WriteScalar(types[i], arrays[i], element - 1, argument.cells[element * arrays.size() + i]);
    }
  }
}

}  // namespace

Result<void> ReadArguments(const Command& command, std::span<const HostArgument> host,
                           const gtcalls::Card* card, MarshalledCall* call) {
  Result<void> result;
  const auto fail = [&result](const Error& error) {
    if (result.ok()) result = error;
  };

  call->with_cells = 0;
  // Values first: among them are the counts that give the number of cells for the pointers.
  for (size_t i = 0; i < host.size(); ++i) {
    const Parameter& parameter = command.parameters[i];
    vm::CommandArgument& argument = call->arguments[i];
    argument = {};
    if (parameter.passing == Passing::kValue) {
      const auto value = ReadValue(parameter, host[i]);
      if (!value) fail(NotALong(parameter));
      argument.value = value.value_or(0);
      continue;
    }
    argument.host = host[i].pointer;
    argument.null = argument.host == nullptr;
    if (IsBadPointer(parameter, argument.host)) {
      argument.null = true;
      fail(BadPointer(parameter, argument.host));
    }
    if (HasCells(parameter) && !argument.null) call->with_cells |= uint32_t{1} << i;
  }

  std::array<size_t, gtcalls::kParameterMax> cell_counts;
  size_t total = 0;
  ForEachIn(call->with_cells, [&](size_t i) {
    const Parameter& parameter = command.parameters[i];
    const auto count = ElementsBehind(command, parameter, call->arguments, card);
    if (!count) {
      fail(BadCount(command, parameter, *call));
      call->arguments[i].null = true;
      call->with_cells &= ~(uint32_t{1} << i);
      return;
    }
    cell_counts[i] = *count * CellsPerElement(parameter);
    total += cell_counts[i];
  });

  if (call->cells.size() < total) call->cells.resize(total);
  double* next_cell = call->cells.data();
  std::fill_n(next_cell, total, 0.0);
  ForEachIn(call->with_cells, [&](size_t i) {
    const Parameter& parameter = command.parameters[i];
    vm::CommandArgument& argument = call->arguments[i];
    argument.cells = {next_cell, cell_counts[i]};
    next_cell += cell_counts[i];
    if (parameter.passing == Passing::kHostMemory) LookForArrays(parameter, argument);
    if (parameter.passing != Passing::kInput) return;
    const auto read = ReadCells(parameter, argument);
    if (!read.ok()) {
      fail(read.error());
      argument.null = true;
    }
  });
  return result;
}

void WriteOutputs(const Command& command, const MarshalledCall& call, int16_t code) {
  if (code != vm::kOk && code != vm::kRefused) return;
  ForEachIn(call.with_cells, [&](size_t i) {
    const Parameter& parameter = command.parameters[i];
    const vm::CommandArgument& argument = call.arguments[i];
    if (parameter.passing == Passing::kHostMemory && code == vm::kOk) {
      FillArrays(parameter, argument);
    }
    if (parameter.passing != Passing::kOutput) return;
    if (code != vm::kOk && !parameter.on_refusal) return;
    if (parameter.structure != nullptr) {
      ForEachStructure(parameter, argument, [&](char* host, std::span<double> cells) {
        StructureFromCells(*parameter.structure, cells, host);
      });
      return;
    }
    for (size_t cell = 0; cell < argument.cells.size(); ++cell) {
      WriteScalar(parameter.type, argument.host, cell, argument.cells[cell]);
    }
  });
}

}  // namespace oncard::runtime
