// Which functions call themselves, alone or in a circle. Functions that call each other are a
// group: a strongly connected part of the graph of calls.
#include <algorithm>

#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {
namespace {

constexpr int kGrouped = -1;  // the mark of a function whose group is known

}  // namespace

// Tarjan's algorithm: `mark` is the number of a function in the order of the visit, `height` the
// smallest one that it leads back to. Both are 0 again at the end.
void Lowerer::FindGroups() {
  struct Visit {
    FunctionInfo* info = nullptr;
    size_t next = 0;  // of its calls
  };
  int visited = 0;
  std::vector<Visit> visits;
  std::vector<FunctionInfo*> open;  // their groups are not known
  const auto begin = [&](FunctionInfo& info) {
    info.mark = info.height = ++visited;
    visits.push_back({&info, 0});
    open.push_back(&info);
  };
  for (FunctionInfo& root : functions_) {
    if (root.mark == 0) begin(root);
    while (!visits.empty()) {
      FunctionInfo& info = *visits.back().info;
      if (visits.back().next < info.calls.size()) {
        FunctionInfo& callee = *info.calls[visits.back().next++].first;
        if (callee.mark == 0) {
          begin(callee);
        } else if (callee.mark != kGrouped) {
          info.height = std::min(info.height, callee.height);
        }
        continue;
      }
      visits.pop_back();
      if (!visits.empty()) {
        FunctionInfo& caller = *visits.back().info;
        caller.height = std::min(caller.height, info.height);
      }
      if (info.height == info.mark) CloseGroup(info, open);
    }
  }
  for (FunctionInfo& info : functions_) info.mark = info.height = 0;
}

// The open functions from a function on call each other.
void Lowerer::CloseGroup(FunctionInfo& first, std::vector<FunctionInfo*>& open) {
  std::vector<FunctionInfo*> members;
  do {
    members.push_back(open.back());
    open.back()->mark = kGrouped;
    open.pop_back();
  } while (members.back() != &first);
  const bool calls_itself =
      std::any_of(first.calls.begin(), first.calls.end(),
                  [&first](const auto& call) { return call.first == &first; });
  if (members.size() == 1 && !calls_itself) return;
  std::sort(members.begin(), members.end(),
            [](const FunctionInfo* a, const FunctionInfo* b) { return a->order < b->order; });
  groups_.push_back({std::move(members)});
  for (FunctionInfo* member : groups_.back().members) {
    member->group = static_cast<int>(groups_.size());
  }
}

}  // namespace oncard::compiler::lowering
