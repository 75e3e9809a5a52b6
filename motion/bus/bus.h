// The bus: a line of slaves, its state machine, the exchange of process data, and the mailbox
// (SDO). It knows slaves and objects; which axis of the card a drive belongs to is up to
// bus_axes.h.
//
// After Init() the state machine goes from INIT through PRE-OP and SAFE-OP to OP, one step in 50 ms
// (assumption). A slave that is lost takes those behind it with it, as they are on one line
// (assumption). Deterministic; not thread-safe. Source: GTS manual S2, 5.2.2; ETG.1000. Tested by
// tests/motion/bus/bus_axes_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "motion/bus/drive.h"
#include "motion/bus/process_data.h"
#include "motion/bus/process_image.h"
#include "motion/bus/slaves.h"
#include "motion/common/sizes.h"

namespace oncard::motion::bus {

enum class BusPhase : uint8_t { kDown, kInit, kPreOp, kSafeOp, kOp };

/// Assumption: the time of each step of the state machine.
inline constexpr Micros kBusStepUs = 50'000;

/// How Init() ended.
enum class InitOutcome : uint8_t { kDone, kNoConfiguration, kNoSlaves, kDifferent };

/// A slave that is connected.
struct SlaveState {
  bool lost = false;    ///< it does not answer at all
  bool silent = false;  ///< it answers, but not to process data (working counter)
  std::optional<BusDrive> drive;
  ProcessImage inputs;  ///< of I/O: what its terminals show, as in the image

  auto Fields(auto visit) const { return visit(lost, silent, drive, inputs); }
};

class Bus {
 public:
  Bus() = default;
  /// What an ENI file describes (nullptr: there is none), and what is connected.
  Bus(SlavesPointer configured, SlavesPointer connected);

  const SlavesPointer& configured() const { return configured_; }
  const SlavesPointer& connected() const { return connected_; }
  SlaveState& slave(size_t number) { return slaves_[number]; }
  const SlaveState& slave(size_t number) const { return slaves_[number]; }
  size_t slave_count() const { return slaves_.size(); }

  // --- Communication -----------------------------------------------------------------------------

  /// How Init() would end.
  InitOutcome CheckInit() const;
  /// Begins communication at that instant; a bus that communicates begins again. Unless it is done,
  /// nothing changes.
  InitOutcome Init(Micros now);
  void Terminate();
  /// One cycle of the state machine, which ends at that instant. True when OP has just been
  /// reached.
  bool AdvancePhase(Micros now);
  BusPhase phase() const { return phase_; }
  /// OP, and every slave answers.
  bool ready() const;
  /// GT_StartEcatComm: the controller commands drives only after it.
  void Start() { started_ = true; }
  bool started() const { return started_ && phase_ == BusPhase::kOp; }
  /// True if neither the slave nor one before it is lost.
  bool Online(size_t number) const;
  /// The same, and it exchanges process data.
  bool Answers(size_t number) const { return Online(number) && !slaves_[number].silent; }

  // --- Process data ------------------------------------------------------------------------------

  ProcessImage& image() { return image_; }
  const ProcessImage& image() const { return image_; }
  const SlavePlace& place(size_t number) const { return (*mapped_)[number].place; }
  /// The input of a slave; empty if its process data do not contain the object.
  std::optional<int64_t> Input(size_t number, ObjectId id) const;
  /// Sets an output of a drive; false if its process data do not contain the object.
  bool SetOutput(size_t number, ObjectId id, int64_t value);
  /// The same for what the controller sends in every cycle, unless a host has just written it.
  void SendOutput(size_t number, ObjectId id, int64_t value);
  std::optional<int64_t> Output(size_t number, ObjectId id) const;
  bool HasOutput(size_t number, ObjectId id) const;
  /// True if the next exchange changes nothing of a drive but positions, as long as its other
  /// outputs stay as they are in the image. Its process data contain the target position, once, and
  /// the measured position, both with all their bits.
  bool ExchangesOnlyPositions(size_t number) const;
  /// Slaves take their outputs (in OP), and give their inputs (in SAFE-OP and OP).
  void TakeOutputs();
  void GiveInputs();
  /// The terminals of a slave show a value: of a drive the object with that ObjectId, of others the
  /// entry of their inputs with that number.
  void SetTerminal(size_t number, size_t item, int64_t value);

  // --- Mailbox -----------------------------------------------------------------------------------

  /// Reads an object into `data`.
  SdoAbort Upload(size_t number, uint16_t index, uint8_t subindex,
                  std::vector<uint8_t>* data) const;
  SdoAbort Download(size_t number, uint16_t index, uint8_t subindex, std::span<const uint8_t> data);

  auto Fields(auto visit) const {
    return visit(configured_, connected_, slaves_, image_, phase_, step_at_, started_);
  }

 private:
  SdoAbort UploadTerminal(size_t number, uint16_t index, uint8_t subindex,
                          std::vector<uint8_t>* data) const;
  SdoAbort DownloadTerminal(size_t number, uint16_t index, uint8_t subindex,
                            std::span<const uint8_t> data);
  /// An object in the process data of a slave; nullptr if they do not contain it.
  const MappedObject* FindInput(size_t number, ObjectId id) const;
  const MappedObject* FindOutput(size_t number, ObjectId id) const;
  int64_t ValueOf(const MappedObject& object) const {
    return image_.Get(object.place.bit, object.place.bits, object.is_signed);
  }
  bool MailboxWorks(size_t number) const {
    return phase_ >= BusPhase::kPreOp && number < slaves_.size() && Online(number);
  }

  SlavesPointer configured_;
  SlavesPointer connected_;
  std::vector<SlaveState> slaves_;
  std::shared_ptr<const std::vector<MappedSlave>> mapped_;  ///< follows from configured_
  ProcessImage image_;
  BusPhase phase_ = BusPhase::kDown;
  Micros step_at_ = 0;  ///< when the present phase began
  bool started_ = false;
};

}  // namespace oncard::motion::bus
