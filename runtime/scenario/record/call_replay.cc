#include "runtime/scenario/record/call_replay.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "gtcalls/card_elements.h"
#include "runtime/scenario/run/scenario_card.h"
#include "vm/object_reader.h"

namespace oncard::runtime {
namespace {

using gtcalls::Parameter;
using gtcalls::Passing;

/// The arguments of a recorded call as commands take them.
class Arguments {
 public:
  /// Without `card` the outputs have no cells: the arguments are only to be shown.
  Arguments(const RecordedCall& call, const gtcalls::Card* card) {
    const auto& parameters = call.command->parameters;
    std::array<size_t, gtcalls::kParameterMax> counts{};
    size_t total = 0;
    count_ = call.arguments.size();
    // Values first: among them are the numbers of elements.
    for (size_t i = 0; i < count_; ++i) arguments_[i].value = call.arguments[i].value;
    for (size_t i = 0; i < count_; ++i) {
      vm::CommandArgument& argument = arguments_[i];
      const RecordedCall::Argument& recorded = call.arguments[i];
      argument.null = recorded.null || recorded.unread;
      if (!recorded.null) argument.host = const_cast<char*>(recorded.text.c_str());
      if (argument.null) continue;
      const Passing passing = parameters[i].passing;
      if (passing == Passing::kInput) {
        counts[i] = recorded.cells.size();
        if (card != nullptr && counts[i] != CellsOf(call, parameters[i], *card)) fits_ = false;
      }
      if ((passing == Passing::kOutput || passing == Passing::kHostMemory) && card != nullptr) {
        counts[i] = CellsOf(call, parameters[i], *card);
      }
      total += counts[i];
    }
    cells_.assign(total, 0.0);
    std::span<double> rest = cells_;
    for (size_t i = 0; i < count_; ++i) {
      arguments_[i].cells = rest.first(counts[i]);
      rest = rest.subspan(counts[i]);
      const auto& recorded = call.arguments[i].cells;
      std::copy_n(recorded.begin(), std::min(recorded.size(), counts[i]),
                  arguments_[i].cells.begin());
    }
  }
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;

  std::span<vm::CommandArgument> span() { return std::span(arguments_).first(count_); }
  /// True if the inputs are as long as the command reads them on this card.
  bool fits() const { return fits_; }

 private:
  /// The cells behind a pointer.
  size_t CellsOf(const RecordedCall& call, const Parameter& parameter, const gtcalls::Card& card) {
    const auto elements = gtcalls::ElementsBehind(*call.command, parameter, span(), &card);
    // The host library has refused all others.
    if (!elements) fits_ = false;
    return elements.value_or(0) * gtcalls::CellsPerElement(parameter);
  }

  std::array<vm::CommandArgument, gtcalls::kParameterMax> arguments_{};
  size_t count_ = 0;
  std::vector<double> cells_;
  bool fits_ = true;
};

Message Deviates(const RecordedCall& call, int16_t code, const Message& reason) {
  return MakeMessage(
      "{0} returns {1}{2} instead of {3} as in the record: the record is of another version of the "
      "card, or it was changed",
      "{0} 返回 {1}{4}，而记录中为 {3}：记录来自另一版本的控制卡，或已被改动",
      FormatInputs(*call.command, Arguments(call, nullptr).span()), code,
      reason.en.empty() ? "" : " (" + reason.en + ")", call.code,
      reason.zh.empty() ? "" : "（" + reason.zh + "）");
}

/// Executes a call that acts on the card.
int16_t Act(const RecordedCall& call, const std::shared_ptr<const vm::Image>& program,
            Arguments* arguments, Controller* controller, Message* reason) {
  if (program != nullptr) {
    controller->Load(program);
    return vm::kOk;
  }
  if (controller->family().Resets(*call.command)) {
    controller->Reset();
    return vm::kOk;
  }
  gtcalls::Card& card = controller->card();
  card.read_file = [&call](const std::string&) -> Result<std::string> {
    if (call.config) return *call.config;
    return MakeError(1, "the file is not in the record", "记录中没有该文件");
  };
  const int16_t code = controller->Execute(*call.command, arguments->span(), reason);
  card.read_file = {};
  return code;
}

}  // namespace

void SwitchOn(const CallRecord& record, Controller* controller) {
  if (!record.bare) ApplyWorld(record.scenario, controller);
}

Result<CallReplay> CallReplay::Create(CallRecord record, const vm::CommandTable& commands) {
  CallReplay replay(std::move(record));
  for (RecordedCall& call : replay.record_.calls) {
    auto& program = replay.program_of_.emplace_back();
    if (!call.program) continue;
    auto object = vm::ReadObject(*call.program);
    if (!object.ok()) return object.error();
    auto image = vm::LinkObject(std::move(object).value(), commands);
    if (!image.ok()) return image.error();
    program = std::move(image).value();
    replay.programs_.push_back(program);
    call.program.emplace();  // the bytes are no longer needed
  }
  return replay;
}

std::optional<Message> CallReplay::Incomplete() const {
  if (record_.end) return std::nullopt;
  return Message{
      "the record ends before the host closed the card: the host was killed, or the file "
      "was cut",
      "记录在主机程序关闭该卡之前结束：主机程序被终止，或文件被截断"};
}

int64_t CallReplay::TimeUs(size_t number) const {
  return number < record_.calls.size() ? record_.calls[number].time_us : record_.end->time_us;
}

std::string CallReplay::Describe(size_t number) const {
  if (number == record_.calls.size()) return FormatClosing();
  const RecordedCall& call = record_.calls[number];
  return FormatInputs(*call.command, Arguments(call, nullptr).span());
}

bool CallReplay::ChangesCard(size_t number) const {
  if (number == record_.calls.size()) return false;
  const RecordedCall& call = record_.calls[number];
  return call.acts && std::ranges::any_of(call.command->accesses, &gtcalls::Access::write);
}

HostCalls::Done CallReplay::Perform(size_t number, Controller* controller, bool described) const {
  if (number == record_.calls.size()) return ExecuteEnd(*controller);
  const RecordedCall& call = record_.calls[number];
  Done done;
  done.code = call.code;
  Message reason = call.reason;
  Arguments arguments(call, call.acts ? &controller->card() : nullptr);
  if (call.acts && !arguments.fits()) {
    done.deviation = MakeMessage(
        "{0} has inputs of another size than the card reads: the record is of another "
        "version of the card, or it was changed",
        "{0} 的输入长度与控制卡读取的不同：记录来自另一版本的控制卡，或已被改动", Describe(number));
  } else if (call.acts) {
    done.code = Act(call, program_of_[number], &arguments, controller, &reason);
    if (done.code != call.code) done.deviation = Deviates(call, done.code, reason);
  }
  if (!described) return done;
  const auto say = [&](Language language) {
    std::string text =
        FormatCallAndCode(*call.command, arguments.span(), done.code, reason, language);
    if (call.acts && done.code == vm::kOk && reason.en.empty()) {
      text += FormatOutputs(*call.command, arguments.span());
    }
    return text;
  };
  done.text = {say(Language::kEnglish), say(Language::kChinese)};
  return done;
}

std::string CallReplay::FormatClosing() const {
  return std::string(record_.family->close_command) + "()";
}

HostCalls::Done CallReplay::ExecuteEnd(const Controller& controller) const {
  Done done;
  done.text = {FormatClosing() + " = 0", FormatClosing() + " = 0"};
  const uint64_t hash = controller.Hash();
  if (hash != record_.end->hash) {
    done.deviation = MakeMessage(
        "at the end of the record the card is in another state than it was: its hash is {0:016x}, "
        "the record's {1:016x}; the record is of another version of the card, or it was changed",
        "在记录结束处，控制卡的状态与当时不同：散列值为 {0:016x}，记录中为 {1:016x}；"
        "记录来自另一版本的控制卡，或已被改动",
        hash, record_.end->hash);
  }
  return done;
}

Result<OpenedCalls> OpenCallRecord(const std::string& text, const std::string& path,
                                   std::optional<int> card, int opening) {
  auto records = ParseCallRecords(text, path);
  if (!records.ok()) return records.error();
  OpenedCalls opened;
  for (const CallRecord& each : records.value()) {
    opened.openings.push_back({each.card, each.opening, each.calls.size()});
  }
  auto record = ChooseCallRecord(std::move(records).value(), card, opening);
  if (!record.ok()) return record.error();
  for (RecordedCall& call : record.value().calls) {
    for (RecordedSource& source : call.sources) {
      const auto is_known = [&](const RecordedSource& known) {
        return known.path == source.path && known.text == source.text;
      };
      if (std::ranges::any_of(opened.sources, is_known)) continue;
      opened.sources.push_back(std::move(source));
    }
    call.sources.clear();
  }
  opened.scenario = record.value().scenario;
  const Controller card_of_record(CardOptions(opened.scenario));
  auto replay = CallReplay::Create(std::move(record).value(), card_of_record.commands());
  if (!replay.ok()) return replay.error();
  opened.calls = std::make_unique<const CallReplay>(std::move(replay).value());
  return opened;
}

}  // namespace oncard::runtime
