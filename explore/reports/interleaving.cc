#include "explore/reports/interleaving.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "explore/reports/culprit.h"
#include "explore/reports/failure_report.h"
#include "explore/reports/step_table.h"

namespace oncard::explore {
namespace {

using Json = nlohmann::ordered_json;

std::string_view NameOf(StepRow::Kind kind) {
  switch (kind) {
    case StepRow::Kind::kStep:
      return "step";
    case StepRow::Kind::kTime:
      return "time";
    case StepRow::Kind::kHost:
      return "host";
    case StepRow::Kind::kRepeat:
      return "repeat";
    case StepRow::Kind::kGap:
      break;
  }
  return "gap";
}

std::string_view NameOf(StaleValue::Kind kind) {
  switch (kind) {
    case StaleValue::Kind::kOverwrites:
      return "overwrites";
    case StaleValue::Kind::kDecides:
      return "decides";
    case StaleValue::Kind::kComputes:
      break;
  }
  return "computes";
}

Json RowJson(const StepRow& row, const Subject& subject, size_t before) {
  Json json = {{"kind", NameOf(row.kind)}};
  if (row.kind == StepRow::Kind::kTime || row.kind == StepRow::Kind::kHost) {
    json["ms"] = row.at_ms;
  } else {
    json["step"] = before + row.step + 1;
    json["last"] = before + row.last + 1;
    if (row.thread >= 0) json["thread"] = subject.threads[static_cast<size_t>(row.thread)].thread;
  }
  if (row.kind == StepRow::Kind::kStep) json["line"] = row.line;
  if (!row.statement.empty()) json["statement"] = row.statement;
  for (const ValueRead& read : row.reads) {
    json["reads"].push_back({{"name", read.name}, {"value", read.value}, {"shared", read.shared}});
  }
  for (const ValueWritten& write : row.writes) {
    json["writes"].push_back({{"name", write.name},
                              {"before", write.before},
                              {"after", write.after},
                              {"shared", write.shared}});
  }
  if (row.escape) json["fatal"] = true;
  return json;
}

/// The rows of steps that come after so many others.
Json RowsJson(StepView view, size_t before, Language language) {
  view.with_gaps = true;
  Json rows = Json::array();
  for (const StepRow& row : RowsOf(view, language).rows) {
    rows.push_back(RowJson(row, view.subject, before));
  }
  return rows;
}

/// An order of a data race up to its end.
Json OrderJson(const Findings& findings, const RaceOrder& order, Language language) {
  StepView view = {findings.subject, order.steps, findings.source};
  view.detail = Detail::kFlow;
  view.named = {order.racing.begin(), order.racing.end()};
  return {{"first", order.first},
          {"racing", {order.racing[0] + 1, order.racing[1] + 1}},
          {"end", order.end},
          {"rows", RowsJson(view, 0, language)}};
}

}  // namespace

nlohmann::ordered_json InterleavingJson(const Findings& findings, const Failure& failure,
                                        Language language) {
  const Trail& trail = findings.trail;
  const auto culprit = FindCulprit(findings.subject, failure, trail);
  Json json = {{"reason", DescribeFault(findings, failure).In(language)}};
  if (!trail.actual.en.empty()) json["actual"] = trail.actual.In(language);
  if (findings.cases) json["choice"] = findings.cases->failing.In(language);
  if (culprit) json["culprit"] = culprit->sentence.In(language);
  for (const ThreadSetup& setup : findings.subject.threads) {
    const auto& function =
        findings.subject.image->object.functions[static_cast<size_t>(setup.function)];
    json["threads"].push_back({{"thread", setup.thread}, {"function", function.name}});
  }
  json["skipped"] = trail.skipped;
  json["rows"] = RowsJson(ViewOf(findings, failure, culprit, Detail::kFlow), 0, language);
  if (failure.livelock) {
    json["cycle"] = RowsJson(CycleOf(findings, Detail::kFlow), trail.steps.size(), language);
  }
  if (culprit && culprit->stale) {
    const StaleValue& stale = *culprit->stale;
    json["stale"] = {{"kind", NameOf(stale.kind)}, {"name", stale.name},
                     {"value", stale.value},       {"changed", stale.changed},
                     {"read", stale.read + 1},     {"write", stale.write + 1},
                     {"use", stale.use + 1}};
  }
  for (const RaceOrder& order : trail.orders) {
    json["orders"].push_back(OrderJson(findings, order, language));
  }
  return json;
}

}  // namespace oncard::explore
