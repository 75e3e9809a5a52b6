// The notation of the GTS catalogue in addition to rows/words.h: parameters with the limits of GTS,
// and names for the sources of its rows.
#pragma once

#include <string_view>

#include "gtcalls/gts/limits.h"
#include "gtcalls/rows/words.h"

namespace oncard::gtcalls::gts::words {

using namespace gtcalls::words;

// --- Sources ------------------------------------------------------------------------------------

inline constexpr std::string_view kManual = "GTS manual ch. 13";
inline constexpr std::string_view kBusManual = "GTS manual S2 ch. 5 and 13";
inline constexpr std::string_view kTable = "GTS manual table 10-2; public header";
inline constexpr std::string_view kTableAssumed = "GTS manual table 10-2; parameters assumed";
inline constexpr std::string_view kNamed = "named in the GTS manuals; public header";
inline constexpr std::string_view kNotes = "GTS application notes; public header";
inline constexpr std::string_view kCompiler = "accepted by the vendor's compiler; public header";
inline constexpr std::string_view kCompilerAssumed =
    "accepted by the vendor's compiler; parameters assumed";
inline constexpr std::string_view kHeader = "public header";
inline constexpr std::string_view kLaserHeader = "public header and laser demonstrations";
inline constexpr std::string_view kLookAheadManual = "multi-axis look-ahead manual ch. 2";
inline constexpr std::string_view kLookAheadNamed =
    "named in the multi-axis look-ahead manual; public header";
inline constexpr std::string_view kThreadHeader = "public header of the thread extensions";

// --- Parameters ---------------------------------------------------------------------------------

/// Axes, and resources with the same numbers: profiles, encoders, controllers, DACs, pulse outputs.
constexpr Spec Axis(std::string_view name) {
  Spec spec = Index(name, 1, kAxisMax);
  spec.parameter.axis_number = true;
  return spec;
}
/// An encoder of an axis, or an auxiliary one.
constexpr Spec Encoder(std::string_view name) {
  Spec spec = Index(name, 1, kAxisMax);
  spec.parameter.encoder_number = true;
  return spec;
}
constexpr Spec Crd() { return Index("crd", 1, kCrdMax); }
/// One of two buffers.
constexpr Spec Fifo() { return Index("fifo", 0, 1); }
constexpr Spec Thread() { return Index("thread", 0, kThreadLast); }
/// The thread whose variables are used; -1: the globals.
constexpr Spec ThreadOrGlobals() { return Index("thread", -1, kThreadLast); }
/// One of two high-speed output channels.
constexpr Spec Channel(std::string_view name) { return Index(name, 0, 1); }
/// In the unit of the laser's mode: percent, kHz or V.
constexpr Spec LaserPower(std::string_view name) { return Double(name).Range(0, kRateBound); }
/// A slave of the bus, counted from 0 in the order of the line.
constexpr Spec SlaveNumber(std::string_view name) { return UShort(name).In(Unit::kIndex); }
/// A number of bytes that a host passes.
constexpr Spec Bytes(Spec spec) { return spec.In(Unit::kByte).Range(1, kBusBytesMax); }
constexpr Spec Module() { return Index("mdl", 0, kModuleLast); }
constexpr Spec ModuleChannel() { return Index("chn", 0, kModuleChannelLast); }
constexpr Spec DiType(std::string_view name) { return Short(name).Range(0, 6); }
constexpr Spec DoType() { return Short("doType").Range(10, 12); }
/// MC_ENABLE: the word of the outputs that enable axes.
inline constexpr int kEnableWord = 10;
constexpr Spec Position(std::string_view name) {
  return Long(name).In(Unit::kPulse).Range(-kPositionMax, kPositionMax);
}
/// Path velocity, acceleration and end velocity of a segment.
constexpr Spec SynVel() {
  return Double("synVel").In(Unit::kPulsePerMs).Range(kAboveZero, kBelow32767);
}
constexpr Spec SynAcc() {
  return Double("synAcc").In(Unit::kPulsePerMs2).Range(kAboveZero, kBelow32767);
}
constexpr Spec VelEnd() { return Double("velEnd").In(Unit::kPulsePerMs).Range(0, kBelow32767); }
/// Parameters of the multi-axis look-ahead: its commands check the ranges, with codes of their own.
constexpr Spec ModuleCrd() { return Short("crd").In(Unit::kIndex); }
constexpr Spec ModuleFifo() { return Short("fifo").Default("0"); }
constexpr Spec Millimetres(std::string_view name) { return Double(name).In(Unit::kMillimetre); }
constexpr Spec ModuleVel() { return Double("synVel").In(Unit::kMmPerS); }
constexpr Spec ModuleAcc() { return Double("synAcc").In(Unit::kMmPerS2); }
constexpr Spec Deceleration(std::string_view name) {
  return Double(name).In(Unit::kPulsePerMs2).Range(kAboveZero, 32767);
}

}  // namespace oncard::gtcalls::gts::words
