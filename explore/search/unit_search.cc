#include "explore/search/unit_search.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string_view>
#include <utility>

#include "base/milliseconds.h"
#include "runtime/observe/card_warnings.h"
#include "runtime/scenario/file/scenario_keys.h"

namespace oncard::explore {
namespace {

/// Units of a search that is not divided: what is lost where it is ended is one of them. States
/// that several groups have are searched in each of them, so that there are not more, and one for
/// each part of a search that is divided.
constexpr int64_t kUnitsOfWhole = 4;

constexpr int64_t kInstantMax = 1'000'000'000'000'000;  ///< in us

// --- Writing -------------------------------------------------------------------------------------

void PutMessages(std::string_view key, const std::vector<Message>& texts, SearchWriter* writer) {
  writer->Next(key);
  writer->Open('[');
  for (const Message& text : texts) {
    writer->Next();
    writer->Open('{');
    writer->PutText("en", text.en);
    writer->PutText("zh", text.zh);
    writer->Close('}');
  }
  writer->Close(']');
}

void PutPlace(const runtime::CommandPlace& place, const Message& text, SearchWriter* writer) {
  writer->Put("thread", place.thread);
  writer->PutText("function", place.function);
  writer->PutText("file", place.file);
  writer->Put("line", place.line);
  writer->PutText("call", place.call);
  PutMessages("text", {text}, writer);
}

void PutTraceCounts(const TraceCounts& traces, SearchWriter* writer) {
  writer->Next("traces");
  writer->Open('{');
  writer->Put("executions", traces.executions);
  writer->Put("blocked", traces.blocked);
  writer->Put("redundant", traces.redundant);
  writer->Put("bad", traces.bad_traces);
  writer->Put("globals", traces.final_globals);
  writer->Put("full", traces.final_full);
  writer->PutFlag("complete", traces.complete);
  writer->PutFlag("counted", traces.counted);
  writer->Close('}');
}

void PutStateCounts(const StateCounts& states, SearchWriter* writer) {
  writer->Next("states");
  writer->Open('{');
  writer->Put("states", states.states);
  writer->Put("transitions", states.transitions);
  writer->Put("bad", states.bad_states);
  writer->Put("globals", states.final_globals);
  writer->Put("full", states.final_full);
  writer->PutList("within", states.finals_within);
  writer->PutFlag("merged", states.merged);
  writer->PutFlag("in_groups", states.in_groups);
  writer->PutFlag("symmetric", states.symmetric);
  writer->PutFlag("complete", states.complete);
  writer->Close('}');
}

void PutIslands(const IslandCounts& islands, SearchWriter* writer) {
  writer->Next("islands");
  writer->Open('{');
  writer->Next("threads");
  writer->Open('[');
  for (const std::vector<int>& island : islands.threads) {
    writer->Next();
    writer->Open('{');
    writer->PutList("island", island);
    writer->Close('}');
  }
  writer->Close(']');
  writer->Next("sums");
  writer->Open('[');
  for (const std::string& sum : islands.sums) {
    writer->Next();
    writer->Open('{');
    writer->PutText("global", sum);
    writer->Close('}');
  }
  writer->Close(']');
  writer->Put("states", islands.states);
  writer->Put("transitions", islands.transitions);
  writer->Close('}');
}

void PutReduced(const ReducedCounts& reduced, SearchWriter* writer) {
  writer->Next("reduced");
  writer->Open('{');
  writer->Put("states", reduced.states);
  writer->Put("transitions", reduced.transitions);
  writer->Put("starts", reduced.starts);
  writer->Close('}');
}

void PutBounded(const BoundedCounts& bounded, SearchWriter* writer) {
  writer->Next("bounded");
  writer->Open('{');
  writer->Put("preemptions", bounded.preemptions);
  writer->Put("states", bounded.states);
  writer->Put("ends", bounded.different_ends);
  writer->PutFlag("bad", bounded.bad);
  writer->PutFlag("complete", bounded.complete);
  writer->Close('}');
}

void PutFound(const Exploration& found, SearchWriter* writer) {
  writer->Next("found");
  writer->Open('{');
  writer->PutText("engine", EngineName(found.engine));
  writer->PutFlag("paired", found.paired);
  writer->PutFlag("passed", found.verdict != Verdict::kProved);
  if (found.horizon.at_ms) writer->Put("horizon_us", std::llround(*found.horizon.at_ms * 1000));
  writer->Put("moving", found.horizon.axes);
  writer->Put("running", found.horizon.threads);
  if (found.traces) PutTraceCounts(*found.traces, writer);
  if (found.states) PutStateCounts(*found.states, writer);
  if (found.islands) PutIslands(*found.islands, writer);
  if (found.reduced) PutReduced(*found.reduced, writer);
  if (found.bounded) PutBounded(*found.bounded, writer);
  EndSet ends;
  for (const End& end : found.ends) ends.Add(end);
  writer->PutEnds("results", ends);
  writer->Close('}');
}

// --- Reading -------------------------------------------------------------------------------------

std::vector<Message> MessagesFrom(SearchReader& reader, const SearchValue& list) {
  std::vector<Message> texts;
  reader.Each(list, [&](const SearchValue& value) {
    std::string en = reader.Text(reader.Member(value, "en"));
    texts.push_back({std::move(en), reader.Text(reader.Member(value, "zh"))});
  });
  return texts;
}

runtime::CommandPlace PlaceFrom(SearchReader& reader, const SearchValue& value, Message* text) {
  runtime::CommandPlace place;
  place.thread = reader.Whole<int>(reader.Member(value, "thread"), -1, kThreadMax - 1);
  place.function = reader.Text(reader.Member(value, "function"));
  place.file = reader.Text(reader.Member(value, "file"));
  place.line = reader.Whole<int>(reader.Member(value, "line"), 0, INT32_MAX);
  place.call = reader.Text(reader.Member(value, "call"));
  const SearchValue texts = reader.Member(value, "text");
  std::vector<Message> read = MessagesFrom(reader, texts);
  if (read.size() != 1) {
    reader.Fail(texts, "one text", "一段文本");
  } else {
    *text = std::move(read.front());
  }
  return place;
}

/// A member that need not be there.
template <typename Counts, typename Read>
void SomeFrom(SearchReader& reader, const SearchValue& value, std::string_view key,
              std::optional<Counts>* counts, const Read& read) {
  const SearchValue member = reader.Member(value, key);
  if (member.json().is_null()) return;
  read(member, &counts->emplace());
}

Exploration FoundFrom(SearchReader& reader, const SearchValue& value) {
  const auto count = [&](const SearchValue& object, std::string_view key) {
    return reader.Count(reader.Member(object, key));
  };
  const auto flag = [&](const SearchValue& object, std::string_view key) {
    return reader.Flag(reader.Member(object, key));
  };
  Exploration found;
  const SearchValue engine = reader.Member(value, "engine");
  const auto named = EngineNamed(reader.Text(engine));
  if (!named) reader.Fail(engine, "an engine", "引擎");
  found.engine = named.value_or(EngineKind::kStateful);
  found.paired = flag(value, "paired");
  found.verdict = flag(value, "passed") ? Verdict::kPassed : Verdict::kProved;
  const SearchValue horizon = reader.Member(value, "horizon_us");
  if (!horizon.json().is_null()) {
    found.horizon.at_ms = ToMs(reader.Whole<int64_t>(horizon, 0, kInstantMax));
  }
  found.horizon.axes = reader.Whole<uint32_t>(reader.Member(value, "moving"), 0, UINT32_MAX);
  found.horizon.threads = reader.Whole<uint32_t>(reader.Member(value, "running"), 0, UINT32_MAX);
  SomeFrom(reader, value, "traces", &found.traces, [&](const SearchValue& from, TraceCounts* to) {
    *to = {count(from, "executions"), count(from, "blocked"), count(from, "redundant"),
           count(from, "bad"),        count(from, "globals"), count(from, "full"),
           flag(from, "complete"),    flag(from, "counted")};
  });
  SomeFrom(reader, value, "states", &found.states, [&](const SearchValue& from, StateCounts* to) {
    *to = {.states = count(from, "states"),
           .transitions = count(from, "transitions"),
           .bad_states = count(from, "bad"),
           .final_globals = count(from, "globals"),
           .final_full = count(from, "full"),
           .merged = flag(from, "merged"),
           .in_groups = flag(from, "in_groups"),
           .finals_within = reader.Wholes<int64_t>(reader.Member(from, "within"), 0, kCountMax),
           .complete = flag(from, "complete"),
           .symmetric = flag(from, "symmetric")};
    if (to->finals_within.size() > kPreemptionBounds) {
      reader.Fail(reader.Member(from, "within"),
                  fmt::format("at most {} numbers", kPreemptionBounds),
                  fmt::format("最多 {} 个数", kPreemptionBounds));
    }
  });
  SomeFrom(reader, value, "islands", &found.islands,
           [&](const SearchValue& from, IslandCounts* to) {
             reader.Each(reader.Member(from, "threads"), [&](const SearchValue& island) {
               to->threads.push_back(
                   reader.Wholes<int>(reader.Member(island, "island"), 0, kThreadMax - 1));
             });
             reader.Each(reader.Member(from, "sums"), [&](const SearchValue& sum) {
               to->sums.push_back(reader.Text(reader.Member(sum, "global")));
             });
             to->states = count(from, "states");
             to->transitions = count(from, "transitions");
           });
  SomeFrom(reader, value, "reduced", &found.reduced,
           [&](const SearchValue& from, ReducedCounts* to) {
             *to = {count(from, "states"), count(from, "transitions"), count(from, "starts")};
           });
  SomeFrom(
      reader, value, "bounded", &found.bounded, [&](const SearchValue& from, BoundedCounts* to) {
        to->preemptions =
            reader.Whole<int>(reader.Member(from, "preemptions"), -1, runtime::kPreemptionsMax);
        to->states = count(from, "states");
        to->different_ends = count(from, "ends");
        to->bad = flag(from, "bad");
        to->complete = flag(from, "complete");
      });
  found.ends = reader.Ends(reader.Member(value, "results")).ends();
  return found;
}

/// Units of parts that the file holds, in order.
std::vector<int64_t> LeftFrom(SearchReader& reader, const SearchValue& list, int64_t units,
                              const std::vector<int>& held, int parts) {
  std::vector<int64_t> left = reader.Wholes<int64_t>(list, 0, units - 1);
  const bool in_order = std::ranges::adjacent_find(left, std::greater_equal{}) == left.end();
  const bool its_own = std::ranges::all_of(left, [&](int64_t unit) {
    return std::ranges::binary_search(held, static_cast<int>(unit % parts) + 1);
  });
  if (!in_order || !its_own) {
    reader.Fail(list, "units of its parts, in order", "所含部分的单元，按顺序排列");
  }
  return left;
}

}  // namespace

int GroupsFor(int64_t cases, int parts) {
  const int64_t units = parts == 1 ? kUnitsOfWhole : parts;
  return static_cast<int>((units + cases - 1) / cases);
}

std::vector<int64_t> UnitsOfPart(int64_t units, int number, int parts) {
  std::vector<int64_t> own;
  for (int64_t unit = number - 1; unit < units; unit += parts) own.push_back(unit);
  return own;
}

void MergeInto(UnitSearch* units, const UnitSearch& others) {
  std::vector<int64_t> left;
  std::ranges::merge(units->left, others.left, std::back_inserter(left));
  units->left = std::move(left);
  if (others.failing && (!units->failing || *others.failing < *units->failing)) {
    units->failing = others.failing;
  }
  if (units->found && others.found) {
    AddCase(*others.found, &*units->found);
  } else if (others.found) {
    units->found = others.found;
  }
}

void MergeInto(Remarks* remarks, const Remarks& others) {
  JoinFound(others.refused, &remarks->refused);
  JoinFound(others.card, &remarks->card);
  remarks->untested.Add(others.untested);
}

void PutUnits(const UnitSearch& units, SearchWriter* writer) {
  writer->Next("units");
  writer->Open('{');
  writer->Put("cases", units.cases);
  writer->Put("groups", units.groups);
  writer->PutFlag("all", units.all);
  writer->PutFlag("islands", units.islands);
  writer->PutFlag("reductions", units.reductions);
  if (units.merge_private) writer->PutFlag("merge_private", *units.merge_private);
  writer->Put("preemptions", units.preemptions);
  writer->PutList("left", units.left);
  if (units.failing) writer->Put("failing", *units.failing);
  if (units.found) PutFound(*units.found, writer);
  writer->Close('}');
}

void PutRemarks(const Remarks& remarks, SearchWriter* writer) {
  writer->Next("remarks");
  writer->Open('{');
  writer->Next("refused");
  writer->Open('[');
  for (const runtime::RefusedCommand& refused : remarks.refused) {
    writer->Next();
    writer->Open('{');
    PutPlace(refused.place, refused.call, writer);
    writer->Put("code", refused.code);
    writer->Put("first_us", refused.first_us);
    writer->Put("count", refused.count);
    writer->Close('}');
  }
  writer->Close(']');
  writer->Next("warnings");
  writer->Open('[');
  for (const runtime::CardFinding& finding : remarks.card) {
    writer->Next();
    writer->Open('{');
    writer->PutText("warning", runtime::InfoOf(finding.warning).name);
    PutPlace(finding.place, finding.text, writer);
    writer->Put("first_us", finding.first_us);
    writer->Put("count", finding.count);
    writer->PutFlag("at_end", finding.at_end);
    writer->Close('}');
  }
  writer->Close(']');
  if (remarks.untested.fewest != UntestedInAll::kNone) {
    writer->Put("fewest_untested", remarks.untested.fewest);
    PutMessages("untested", remarks.untested.common, writer);
    PutMessages("first_untested", remarks.untested.first, writer);
  }
  writer->Close('}');
}

UnitSearch UnitsFrom(SearchReader& reader, const SearchValue& value, const std::vector<int>& held,
                     int parts) {
  UnitSearch units;
  units.cases =
      reader.Whole<int64_t>(reader.Member(value, "cases"), 1, runtime::Choices::kCasesMax);
  units.groups = reader.Whole<int>(reader.Member(value, "groups"), 1, UnitSearch::kGroupsMax);
  units.all = reader.Flag(reader.Member(value, "all"));
  units.islands = reader.Flag(reader.Member(value, "islands"));
  units.reductions = reader.Flag(reader.Member(value, "reductions"));
  const SearchValue merge = reader.Member(value, "merge_private");
  if (!merge.json().is_null()) units.merge_private = reader.Flag(merge);
  units.preemptions =
      reader.Whole<int>(reader.Member(value, "preemptions"), 0, runtime::kPreemptionsMax);
  units.left = LeftFrom(reader, reader.Member(value, "left"), units.units(), held, parts);
  const SearchValue failing = reader.Member(value, "failing");
  if (!failing.json().is_null()) {
    units.failing = reader.Whole<int64_t>(failing, 0, units.units() - 1);
  }
  const SearchValue found = reader.Member(value, "found");
  if (!found.json().is_null()) units.found = FoundFrom(reader, found);
  return units;
}

Remarks RemarksFrom(SearchReader& reader, const SearchValue& value) {
  Remarks remarks;
  reader.Each(reader.Member(value, "refused"), [&](const SearchValue& from) {
    runtime::RefusedCommand refused;
    refused.place = PlaceFrom(reader, from, &refused.call);
    refused.code = reader.Whole<int16_t>(reader.Member(from, "code"), INT16_MIN, INT16_MAX);
    refused.first_us = reader.Whole<int64_t>(reader.Member(from, "first_us"), 0, kInstantMax);
    refused.count = reader.Count(reader.Member(from, "count"));
    remarks.refused.push_back(std::move(refused));
  });
  reader.Each(reader.Member(value, "warnings"), [&](const SearchValue& from) {
    const SearchValue name = reader.Member(from, "warning");
    const runtime::CardWarningInfo* info = runtime::FindCardWarning(reader.Text(name));
    if (info == nullptr) return reader.Fail(name, "a warning", "警告名");
    runtime::CardFinding finding;
    finding.warning = info->warning;
    finding.place = PlaceFrom(reader, from, &finding.text);
    finding.first_us = reader.Whole<int64_t>(reader.Member(from, "first_us"), 0, kInstantMax);
    finding.count = reader.Count(reader.Member(from, "count"));
    finding.at_end = reader.Flag(reader.Member(from, "at_end"));
    remarks.card.push_back(std::move(finding));
  });
  const SearchValue fewest = reader.Member(value, "fewest_untested");
  if (!fewest.json().is_null()) {
    remarks.untested.fewest = reader.Count(fewest);
    remarks.untested.common = MessagesFrom(reader, reader.Member(value, "untested"));
    remarks.untested.first = MessagesFrom(reader, reader.Member(value, "first_untested"));
  }
  return remarks;
}

}  // namespace oncard::explore
