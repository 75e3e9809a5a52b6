// Which functions call themselves, alone or in a circle, and how many of their calls run at the
// same time, at most. Functions that call each other are a group: a strongly connected part of the
// graph of calls, without those that tail_calls.cc makes jumps. A group needs a depth: a comment
// `//@ depth` above one of its functions, or the one of the file, or what proved_depth.cc finds.
// frames.cc has what becomes of its calls.
#include <fmt/core.h>

#include <algorithm>

#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {
namespace {

constexpr int kCallDepthMax = 16;

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
  groups_.push_back({std::move(members), 0});
  for (FunctionInfo* member : groups_.back().members) {
    member->group = static_cast<int>(groups_.size());
  }
}

void Lowerer::PlaceDepths(const Tree& tree, const std::vector<DepthComment>& depths) {
  for (const DepthComment& comment : depths) {
    if (comment.depth) {
      PlaceDepth(tree, comment);
    } else {
      Report(Code::kDepth, comment.range,
             MakeMessage("it needs a number from 1 to {0}, as in '//@ depth: 8'",
                         "需要 1 至 {0} 的数，例如 '//@ depth: 8'", kFramesMax));
    }
  }
}

// Gives a comment to the function that it stands right above, or to all.
void Lowerer::PlaceDepth(const Tree& tree, const DepthComment& comment) {
  const Function* below = nullptr;
  for (const StatementPtr& item : tree.items) {
    if (item->kind != Statement::Kind::kFunction) continue;
    const Function& function = *item->function;
    if (function.header.file != comment.range.file) continue;
    if (function.header.begin >= comment.range.end) {
      if (below == nullptr) below = &function;
    } else if (!function.prototype && comment.range.begin < function.close_brace.end) {
      Report(Code::kDepth, comment.range,
             MakeMessage("it stands in a function; write it above the function",
                         "位于函数之内；请写在函数上方"));
      return;
    }
  }
  const std::string_view text = files_[static_cast<size_t>(comment.range.file)].text();
  const bool for_all = below == nullptr || !IsRightAbove(text, comment.range, below->header);
  FunctionInfo* const info = for_all ? nullptr : scopes_[0].at(below->name).function;
  const bool calls_itself = info != nullptr && (info->group != 0 || !info->tail_calls.empty());
  if (!for_all && !calls_itself) {
    Report(Code::kDepth, comment.range,
           MakeMessage("'{0}' does not call itself; remove the comment",
                       "'{0}' 不调用自身；请删除此注释", below->name));
    return;
  }
  const DepthComment*& place = for_all ? depth_of_all_ : info->depth;
  if (place != nullptr && place->depth != comment.depth) {
    Diagnostic* const diagnostic =
        Report(Code::kDepth, comment.range,
               MakeMessage("there is another one; keep one of them", "已有另一条；请只保留一条"));
    if (diagnostic != nullptr) {
      AddNote(*diagnostic, place->range, MakeMessage("the other one", "另一条在此"));
    }
  }
  place = &comment;
}

// The functions of a group have one depth.
void Lowerer::SetDepths() {
  for (Group& group : groups_) {
    const DepthComment* depth = nullptr;
    for (const FunctionInfo* member : group.members) {
      if (member->depth == nullptr) continue;
      if (depth != nullptr && depth->depth != member->depth->depth) {
        Report(Code::kDepth, member->depth->range,
               MakeMessage("'{0}' and '{1}' call each other and share their frames; give both the "
                           "same depth",
                           "'{0}' 与 '{1}' 相互调用，共用调用帧；请给出相同的深度",
                           group.members[0]->syntax->name, member->syntax->name));
      }
      depth = member->depth;
    }
    if (depth == nullptr) depth = depth_of_all_;
    if (depth != nullptr) group.depth = *depth->depth;
  }
}

// Whether functions outside of a group call it.
bool Lowerer::HasCallers(const Group& group) const {
  return std::any_of(functions_.begin(), functions_.end(), [&group](const FunctionInfo& info) {
    return info.group != group.members[0]->group &&
           std::any_of(info.calls.begin(), info.calls.end(), [&group](const auto& call) {
             return call.first->group == group.members[0]->group;
           });
  });
}

// Follows the calls of a function; reports those that lead back to a function without a depth, or
// too deep.
bool Lowerer::RecursesUnbounded(FunctionInfo& info, std::vector<FunctionInfo*>& path) {
  constexpr int kOpen = 1;
  constexpr int kClosed = 2;
  info.mark = kOpen;
  path.push_back(&info);
  bool unbounded = false;
  for (const auto& [callee, call] : info.calls) {
    if (callee->mark != kOpen) {
      // A level of calls takes the stack of all that a function can nest.
      const bool deep = static_cast<int>(path.size()) + callee->height >= kCallDepthMax;
      if (deep) Report(Code::kTooDeep, call->range, int64_t{kCallDepthMax});
      unbounded |= deep || (callee->mark != kClosed && RecursesUnbounded(*callee, path));
      info.height = std::max(info.height, callee->height + 1);
      continue;
    }
    const Group& group = GroupOf(info);
    if (!HasCallers(group)) {
      Report(Code::kNotLowered, group.members[0]->syntax->name_range,
             MakeMessage("a thread function that is called", "被调用的线程函数"),
             MakeMessage("call '{0}' in another function, which the host starts",
                         "请在另一个由主机启动的函数中调用 '{0}'", group.members[0]->syntax->name));
      unbounded = true;
      continue;
    }
    if (group.depth > 0) continue;
    std::string cycle;
    bool inside = false;
    for (const FunctionInfo* function : path) {
      inside |= function == callee;
      if (inside) cycle += fmt::format("{} -> ", function->syntax->name);
    }
    Report(Code::kRecursion, call->range, callee->syntax->name,
           cycle + std::string(callee->syntax->name));
    unbounded = true;
  }
  path.pop_back();
  info.mark = kClosed;
  return unbounded;
}

// Whether all calls of a group within it pass a name for a parameter: the array begins where it
// did.
bool Lowerer::PassesNames(const FunctionInfo& info, size_t parameter) const {
  const std::vector<FunctionInfo*>& members = groups_[static_cast<size_t>(info.group) - 1].members;
  return std::all_of(members.begin(), members.end(), [&](const FunctionInfo* member) {
    return std::all_of(member->calls.begin(), member->calls.end(), [&](const auto& call) {
      const auto& [callee, expression] = call;
      if (callee != &info || expression->operands.size() <= parameter + 1) return true;
      const Expression* argument = &WithoutParens(*expression->operands[parameter + 1]);
      if (argument->kind == Expression::Kind::kUnary && argument->op == "&") {
        argument = &WithoutParens(*argument->operands[0]);
      }
      return argument->kind == Expression::Kind::kName;
    });
  });
}

}  // namespace oncard::compiler::lowering
