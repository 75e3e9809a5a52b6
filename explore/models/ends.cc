#include "explore/models/ends.h"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <utility>

#include "runtime/observe/quantity.h"

namespace oncard::explore {
namespace {

/// Calls `visit(symbol, slot)` for every slot of the globals.
template <typename Visit>
void ForEachGlobal(const vm::Object& object, const Visit& visit) {
  for (const vm::Symbol& symbol : object.globals) {
    for (uint32_t i = 0; i < symbol.slots(); ++i) visit(symbol, symbol.id + i);
  }
}

std::string ValueText(int64_t raw, vm::DataType type) {
  const double value = type == vm::DataType::kDouble
                           ? vm::DoubleFromFixed(raw)
                           : static_cast<double>(static_cast<int32_t>(raw));
  return runtime::FormatNumber(value, runtime::FormOf(type));
}

}  // namespace

End EndOf(const Model& model) {
  End end;
  ForEachGlobal(model.image().object, [&](const vm::Symbol& symbol, uint32_t slot) {
    end.push_back(model.Read(
        {.global = true, .page = 0, .id = static_cast<uint16_t>(slot), .type = symbol.type}));
  });
  for (int thread = 0; thread < model.thread_count(); ++thread) {
    end.push_back(model.ReturnValue(thread));
  }
  return end;
}

End EndOf(const CardModel& model, const CardModel::State& state) {
  End end;
  const std::span<const int64_t> globals = state.variables.Globals();
  ForEachGlobal(model.image()->object, [&](const vm::Symbol&, uint32_t slot) {
    end.push_back(slot < globals.size() ? globals[slot] : 0);
  });
  for (const ThreadSetup& setup : model.setups()) {
    end.push_back(state.threads[static_cast<size_t>(setup.thread)].result);
  }
  return end;
}

void EndSet::Add(End end) {
  if (ends_.size() == kKept && !(end < ends_.back())) return;
  const auto at = std::ranges::lower_bound(ends_, end);
  if (at != ends_.end() && *at == end) return;
  ends_.insert(at, std::move(end));
  if (ends_.size() > kKept) ends_.pop_back();
}

std::vector<std::vector<NamedValue>> NameEnds(const std::vector<End>& ends,
                                              const vm::Object& object,
                                              const std::vector<ThreadSetup>& threads) {
  std::vector<std::vector<NamedValue>> named(ends.size());
  for (size_t i = 0; i < ends.size(); ++i) {
    auto raw = ends[i].begin();
    ForEachGlobal(object, [&](const vm::Symbol& symbol, uint32_t slot) {
      named[i].push_back({NameOfSlot(object.globals, slot), ValueText(*raw++, symbol.type)});
    });
    for (const ThreadSetup& setup : threads) {
      const vm::Function& function = object.functions[static_cast<size_t>(setup.function)];
      named[i].push_back(
          {fmt::format("ret{}", setup.thread), ValueText(*raw++, function.return_type)});
    }
  }
  return named;
}

}  // namespace oncard::explore
