// Extension modules. Modules, bits and channels are numbered from 0.
// Source: GTS manual table 10-2; the public header for parameters and for the state of a module.
// Tested by tests/gtcalls/extension_command_test.cc.
#include "gtcalls/gts/commands/commands.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::ExtensionModule;

/// GT_GetStsExtMdl: 0 for a module that works, 1 for a fault.
constexpr int kModuleFault = 1;

const ExtensionModule& ExtensionOf(const Call& call) {
  const auto module = static_cast<size_t>(call.integer(0));
  return call.card.motion.part<&motion::MotionState::modules>()[module];
}
size_t ExtensionChannelOf(const Call& call) { return static_cast<size_t>(call.integer(1)); }

/// 0, or 1 with the reason if no such module is connected.
int16_t CheckModule(Call& call) {
  if (ExtensionOf(call).present) return vm::kOk;
  return call.Refuse(
      vm::kRefused,
      MakeMessage(
          "no extension module {0} is connected; the scenario lists the modules that are present",
          "未连接扩展模块 {0}；场景的 world 中列出了已连接的模块", call.integer(0)));
}

/// Execute a command on a module, which must be connected.
template <void (*function)(Call&, const ExtensionModule&)>
int16_t ReadModule(Call& call) {
  const int16_t code = CheckModule(call);
  if (code == vm::kOk) function(call, ExtensionOf(call));
  return code;
}
template <void (*function)(Call&, ExtensionModule&)>
int16_t WriteModule(Call& call) {
  const int16_t code = CheckModule(call);
  if (code == vm::kOk)
    function(call, call.card.motion.module(static_cast<size_t>(call.integer(0))));
  return code;
}

void SetIoValue(Call& call, ExtensionModule& module) {
  module.outputs = static_cast<uint16_t>(call.integer(1));
}

void GetIoValue(Call& call, const ExtensionModule& module) { call.Set(1, module.inputs); }

void SetIoBit(Call& call, ExtensionModule& module) {
  const auto bit = static_cast<uint16_t>(1u << call.integer(1));
  const int word = call.integer(2) != 0 ? module.outputs | bit : module.outputs & ~bit;
  module.outputs = static_cast<uint16_t>(word);
}

void GetIoBit(Call& call, const ExtensionModule& module) {
  call.Set(2, module.inputs >> call.integer(1) & 1);
}

void GetAdValue(Call& call, const ExtensionModule& module) {
  call.Set(2, motion::ModuleValue(module.input_volts[ExtensionChannelOf(call)]));
}

/// The converter's value for the voltage.
void GetAdVoltage(Call& call, const ExtensionModule& module) {
  call.Set(2,
           motion::ModuleVolts(motion::ModuleValue(module.input_volts[ExtensionChannelOf(call)])));
}

void SetDaValue(Call& call, ExtensionModule& module) {
  module.output_volts[ExtensionChannelOf(call)] =
      motion::ModuleVolts(static_cast<uint16_t>(call.integer(2)));
}

void SetDaVoltage(Call& call, ExtensionModule& module) {
  module.output_volts[ExtensionChannelOf(call)] = call.value(2);
}

}  // namespace

/// A missing module is the result of this command, not a reason to refuse it.
int16_t GT_GetStsExtMdl(Call& call) {
  call.Set(2, ExtensionOf(call).present ? 0 : kModuleFault);
  return vm::kOk;
}

int16_t GT_SetExtIoValue(Call& call) { return WriteModule<SetIoValue>(call); }
int16_t GT_GetExtIoValue(Call& call) { return ReadModule<GetIoValue>(call); }
int16_t GT_SetExtIoBit(Call& call) { return WriteModule<SetIoBit>(call); }
int16_t GT_GetExtIoBit(Call& call) { return ReadModule<GetIoBit>(call); }
int16_t GT_GetExtAdValue(Call& call) { return ReadModule<GetAdValue>(call); }
int16_t GT_GetExtAdVoltage(Call& call) { return ReadModule<GetAdVoltage>(call); }
int16_t GT_SetExtDaValue(Call& call) { return WriteModule<SetDaValue>(call); }
int16_t GT_SetExtDaVoltage(Call& call) { return WriteModule<SetDaVoltage>(call); }

}  // namespace oncard::gtcalls::gts
