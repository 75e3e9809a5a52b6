// A host for tests that makes calls, with their record.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "gtcalls/card_type.h"
#include "gtcalls/family.h"
#include "runtime/scenario/record/call_record.h"
#include "runtime/scenario/run/scenario_card.h"
#include "tests/runtime/scenario_support.h"
#include "vm/object_writer.h"

namespace oncard::runtime {

/// Makes calls every 50 us, on a GTS card unless another one is named.
class RecordingHost {
 public:
  explicit RecordingHost(std::string_view card = {})
      : scenario_(OfCard(card)), controller_(CardOptions(scenario_)) {
    text_ = FormatRecordHead() + FormatRecordedOpening(0, scenario_, true);
  }

  void Call(const std::string& name, const std::vector<double>& values) {
    std::vector<vm::CommandArgument> arguments(values.size());
    for (size_t i = 0; i < values.size(); ++i) arguments[i].value = values[i];
    const gtcalls::Command& command = *controller_.family().catalogue.Find(name);
    Message reason;
    // A call may end with a later tick.
    controller_.AdvanceUs(controller_.family().cost_us(command));
    const int64_t time_us = controller_.NowUs();
    const int16_t code = controller_.Execute(command, arguments, &reason);
    Write(RecordCall({time_us, 0, vm::kHostCaller, command, arguments, code, reason}, true));
  }
  void Download(const std::string& name, const std::string& source) {
    const vm::Object object = CompileForTest(source);
    controller_.AdvanceUs(50);
    EXPECT_TRUE(controller_.Load(object).ok());
    RecordedCall call;
    call.time_us = controller_.NowUs();
    call.command = controller_.family().catalogue.Find("GT_Download");
    call.arguments.resize(1);
    call.arguments[0].text = name + ".bin";
    call.program = vm::WriteObject(object, false);
    call.sources.push_back({"/programs/" + name + ".c", source});
    Write(call);
  }
  /// Function 1 of the program on thread 0 and page 0.
  void Start() {
    Call("GT_Bind", {0, 1, 0});
    Call("GT_RunThread", {0});
  }
  void Wait(int64_t microseconds) { controller_.AdvanceUs(microseconds); }
  void Close() { text_ += FormatRecordedEnd(0, {controller_.NowUs(), controller_.Hash()}); }

  const std::string& text() const { return text_; }

 private:
  static Scenario OfCard(std::string_view name) {
    Scenario scenario;
    if (const auto card = gtcalls::FindCard(name)) {
      scenario.card = name;
      scenario.axis_count = card->type->axis_count;
    }
    return scenario;
  }
  void Write(const RecordedCall& call) { AppendRecordedCall(0, call, &text_); }

  Scenario scenario_;
  Controller controller_;
  std::string text_;
};

}  // namespace oncard::runtime
