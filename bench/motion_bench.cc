// `oncard_bench motion`: measures the time of a profile cycle per axis, how much faster than real
// time a card runs (also cycle by cycle, and with its axes on a bus), the time of a path segment,
// and the time of a command of the C API. CPU time, the shortest of several repetitions.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.h"
#include "gtcalls/families.h"
#include "gtcalls/family.h"
#include "gts.h"
#include "motion/motion_core.h"

namespace oncard::bench {
namespace {

// Prints the cost of a cycle, and returns how many times faster than real time the card is.
double PrintTicks(const char* what, const motion::MotionConfig& config, int64_t ticks,
                  double seconds) {
  const double nanoseconds = seconds * 1e9 / static_cast<double>(ticks);
  const double simulated = static_cast<double>(ticks * config.cycle_us) * 1e-6;
  std::printf("%-44s %8.1f ns/cycle %7.1f ns/axis-cycle %9.0f x real time\n", what, nanoseconds,
              nanoseconds / config.axis_count, simulated / seconds);
  return simulated / seconds;
}

// A card on which nothing moves, 100 ms at a time.
void MeasureIdle() {
  constexpr int64_t kTicks = 500'000;
  constexpr int64_t kBlock = 400;
  motion::MotionConfig config;
  config.axis_count = 12;
  motion::MotionCore core(config);
  const double seconds = MeasureCpu([&] {
    for (int64_t i = 0; i < kTicks; i += kBlock) core.Advance(kBlock);
  });
  PrintTicks("12 axes, idle, 250 us", config, kTicks, seconds);
}

// Example 7-1 of the GTS manual on 8 axes, back and forth without a pause.
void MeasureTrap() {
  constexpr int64_t kTicks = 500'000;
  motion::MotionConfig config;
  config.axis_count = 8;
  config.cycle_us = 1000;
  motion::MotionCore core(config);
  for (size_t i = 0; i < core.axis_count(); ++i) {
    core.ProfileAt(i).SetParameters(motion::TrapParameters{0.25, 0.125, 0, 25});
    core.ProfileAt(i).SetVelocity(50);
  }
  int64_t moves = 0;
  const double seconds = MeasureCpu([&] {
    for (int64_t tick = 0; tick < kTicks; ++tick) {
      for (size_t i = 0; i < core.axis_count(); ++i) {
        const motion::Profile& profile = core.profile(i);
        if (profile.now.moving) continue;
        core.ProfileAt(i).SetTarget(profile.trap.target == 0 ? 50'000 : 0);
        core.ProfileAt(i).Start();
        ++moves;
      }
      core.Tick();
    }
  });
  if (moves < 8 * kTicks / 1400) Fail("the axes did not move");
  PrintTicks("8 axes, Trap without servo, 1 ms", config, kTicks, seconds);
}

// Closed loop: 12 axes jog, each with its own controller and velocity drive.
void BeginServo(motion::MotionCore& core) {
  for (size_t i = 0; i < core.axis_count(); ++i) {
    core.ConnectDrive(i, motion::VelocityDrive(100, 2, 0, core.config().ServoMs()));
    core.ControlAt(i).SetPidSet(0, {.kp = 20});
    core.AxisAt(i).SetClosedLoop(true);
    core.AxisAt(i).ServoOn();
    core.ProfileAt(i).SelectMode(motion::ProfileMode::kJog);
    core.ProfileAt(i).SetVelocity(10);
    core.ProfileAt(i).Start();
  }
}

// With each instruction set that the computer has, the fastest first, and cycle by cycle without
// lanes. All end in the same state.
void MeasureServo() {
  constexpr int64_t kTicks = 200'000;
  motion::MotionConfig config;
  config.axis_count = 12;
  motion::MotionCore ticked(config);
  BeginServo(ticked);
  const double single = MeasureCpu([&] {
    for (int64_t i = 0; i < kTicks; ++i) ticked.Tick();
  });
  double fastest = 0;
  for (const motion::NamedLaneKernel& kernel : motion::LaneKernels()) {
    motion::MotionCore core(config);
    core.UseKernel(kernel.run);
    BeginServo(core);
    const double seconds = MeasureCpu([&] { core.Advance(kTicks); });
    if (core.Hash() != ticked.Hash()) Fail("lanes and single cycles end in different states");
    const std::string what = "12 axes, Jog with servo, 250 us, " + std::string(kernel.name);
    const double faster = PrintTicks(what.c_str(), config, kTicks, seconds);
    fastest = std::max(fastest, faster);
  }
  PrintTicks("12 axes, Jog with servo, 250 us, ticks", config, kTicks, single);
  const motion::Axis& last = ticked.state().axes[ticked.axis_count() - 1];
  if (last.encoder.velocity < 5) Fail("the drives did not follow");
  std::printf("12 axes with servo: %.0f x real time\n", fastest);
}

// The same a cycle at a time, as between the calls of a host that looks at its card all the time.
void MeasureShortWays() {
  constexpr int64_t kCycles = 200'000;
  motion::MotionConfig config;
  config.axis_count = 12;
  const auto measure = [&](const char* what, const auto& after_each) {
    motion::MotionCore core(config);
    BeginServo(core);
    const double seconds = MeasureCpu([&] {
      for (int64_t i = 0; i < kCycles; ++i) {
        core.Advance(1);
        after_each(core);
      }
    });
    if (core.encoder(0).velocity < 5) Fail("the drives did not follow");
    PrintTicks(what, config, kCycles, seconds);
  };
  double sum = 0;
  measure("the same, a cycle at a time", [](const motion::MotionCore&) {});
  measure("  and a position is read",
          [&](const motion::MotionCore& core) { sum += core.profile(0).now.position; });
  measure("  and the whole state is read",
          [&](const motion::MotionCore& core) { sum += core.state().plants[0].position; });
  measure("  and a profile is started",
          [](motion::MotionCore& core) { core.ProfileAt(0).Start(); });
  measure("  and something is changed",
          [](motion::MotionCore& core) { core.AxisAt(0).SwitchAlarm(true); });
  if (sum <= 0) Fail("the axes did not move");
}

// A line of all axes that none of the measurements runs to its end.
void BeginLine(motion::MotionCore& core) {
  motion::CrdParameters parameters = {.velocity_max = 100, .acceleration_max = 1};
  parameters.dimension = static_cast<int16_t>(core.axis_count());
  motion::PathSlot slot;
  motion::Coordinates end{};
  for (size_t i = 0; i < core.axis_count(); ++i) {
    parameters.coordinates[i] = static_cast<int16_t>(i + 1);
    end[i] = 1e6;
  }
  slot.is_segment = true;
  slot.segment = *motion::MakeLine({}, end);
  slot.velocity = 10;
  slot.acceleration = 1;
  core.CrdAt(0).SetUp(parameters);
  if (!core.CrdAt(0).Append(0, slot)) Fail("the line does not fit");
  core.CrdAt(0).Start(0, false);
}

void BeginJog(motion::MotionCore& core) {
  for (size_t i = 0; i < core.axis_count(); ++i) {
    core.ProfileAt(i).SelectMode(motion::ProfileMode::kJog);
    core.ProfileAt(i).SetVelocity(10);
    core.ProfileAt(i).Start();
  }
}

// The older cards, all of whose axes move: each by itself, or along a line.
void MeasureOlderCards() {
  constexpr int64_t kTicks = 200'000;
  for (const gtcalls::Family* family : gtcalls::Families()) {
    if (family->HasPrograms()) continue;
    const bool has_paths = !family->advised.start_path.empty();
    for (const gtcalls::CardType& type : family->card_types) {
      motion::MotionConfig config;
      config.axis_count = type.axis_count;
      config = family->Configured(config, &type);
      const double seconds = MeasureCpu([&] {
        motion::MotionCore core(config);
        if (has_paths) {
          BeginLine(core);
        } else {
          BeginJog(core);
        }
        core.Advance(kTicks);
        if (!core.profile(0).now.moving) Fail("the axes did not move");
      });
      const std::string what = std::string(type.name) + (has_paths ? ", a line" : ", mode V");
      PrintTicks(what.c_str(), config, kTicks, seconds);
    }
  }
}

// 12 drives on an EtherCAT bus follow jogging axes.
void BeginBus(motion::MotionCore& core, motion::DriveKind kind) {
  motion::bus::Slaves drives;
  for (size_t i = 0; i < core.axis_count(); ++i) {
    drives.push_back(motion::bus::DefaultSlave(motion::bus::SlaveKind::kDrive));
    drives.back().axis = static_cast<int8_t>(i);
    if (kind == motion::DriveKind::kIdeal) continue;
    core.ConnectDrive(i, motion::VelocityDrive(100, 2, 0, core.config().ServoMs()));
  }
  const auto slaves = std::make_shared<const motion::bus::Slaves>(std::move(drives));
  core.ConnectBus(slaves, slaves);
  motion::bus::Bus& bus = *core.bus_line();
  if (bus.Init(core.now()) != motion::bus::InitOutcome::kDone) Fail("the bus does not begin");
  while (!bus.ready()) core.Tick();
  bus.Start();
  for (size_t i = 0; i < core.axis_count(); ++i) {
    core.AxisAt(i).ServoOn();
    core.ProfileAt(i).SelectMode(motion::ProfileMode::kJog);
    core.ProfileAt(i).SetVelocity(10);
  }
  for (int i = 0; i < 8; ++i) core.Tick();
  for (size_t i = 0; i < core.axis_count(); ++i) core.ProfileAt(i).Start();
}

// As lanes, a millisecond at a time as between the calls of a host, and cycle by cycle without
// lanes. All end in the same state.
void MeasureBus(motion::DriveKind kind, const std::string& what) {
  constexpr int64_t kTicks = 200'000;
  constexpr int64_t kMs = 4;
  motion::MotionConfig config;
  config.axis_count = 12;
  uint64_t end = 0;
  const auto measure = [&](const char* way, const auto& advance) {
    motion::MotionCore core(config);
    BeginBus(core, kind);
    const double seconds = MeasureCpu([&] { advance(core); });
    if (core.encoder(core.axis_count() - 1).position < 1e5) Fail("the drives did not follow");
    if (end == 0) end = core.Hash();
    if (core.Hash() != end) Fail("lanes and single cycles end in different states");
    PrintTicks((what + way).c_str(), config, kTicks, seconds);
  };
  double sum = 0;
  measure(", ticks", [](motion::MotionCore& core) {
    for (int64_t i = 0; i < kTicks; ++i) core.Tick();
  });
  measure("", [](motion::MotionCore& core) { core.Advance(kTicks); });
  measure(", a position each ms", [&](motion::MotionCore& core) {
    for (int64_t i = 0; i < kTicks; i += kMs) {
      core.Advance(kMs);
      sum += core.encoder(0).position;
    }
  });
  measure(", the state each ms", [&](motion::MotionCore& core) {
    for (int64_t i = 0; i < kTicks; i += kMs) {
      core.Advance(kMs);
      sum += std::as_const(core).state().plants[0].position;
    }
  });
  if (sum <= 0) Fail("the axes did not move");
}

// A path of a million short lines with a look-ahead of 200, filled whenever the FIFO has space. The
// path is a polygon with 360 sides of 3 pulses; it must never come to rest before the end.
void MeasurePath() {
  constexpr int kSegments = 1'000'000;
  constexpr int kSides = 360;
  constexpr double kSide = 3;
  std::vector<motion::Coordinates> corners;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * M_PI * i / kSides;
    const double radius = kSide * kSides / (2 * M_PI);
    corners.push_back({radius * std::sin(angle), radius - radius * std::cos(angle)});
  }
  int64_t ticks = 0;
  const double seconds = MeasureCpu([&] {
    motion::MotionConfig config;
    config.cycle_us = 1000;
    motion::MotionCore core(config);
    core.CrdAt(0).SetUp(
        {.dimension = 2, .coordinates = {1, 2}, .velocity_max = 100, .acceleration_max = 1});
    core.CrdAt(0).BeginLookAhead(0, 5, 1, 200);
    const motion::Crd& crd = core.part<&motion::MotionState::crds>()[0];
    const motion::CrdFifo& fifo = crd.fifos[0];
    const auto append = [&](int number) {
      motion::PathSlot slot;
      slot.is_segment = true;
      slot.segment = *motion::MakeLine(corners[static_cast<size_t>(number % kSides)],
                                       corners[static_cast<size_t>((number + 1) % kSides)]);
      slot.velocity = 15;
      slot.acceleration = 0.2;
      return core.CrdAt(0).Append(0, slot);
    };
    int sent = 0;
    ticks = 0;
    while (sent < kSegments && append(sent)) ++sent;
    core.CrdAt(0).Start(0, false);
    for (; crd.run.running; ++ticks) {
      while (sent < kSegments && append(sent)) ++sent;
      if (sent == kSegments && !fifo.Ahead().empty()) core.CrdAt(0).Flush(0);
      core.Tick();
    }
    if (sent != kSegments || fifo.done != kSegments) Fail("the path has not been run to its end");
  });
  // 3 million pulses at 15 pulse/ms, and less than a second for acceleration and deceleration.
  if (ticks > 201'000) Fail("the path was interrupted");
  std::printf("%-44s %8.1f ns/segment, cycles included\n", "1 million segments through look-ahead",
              seconds * 1e9 / kSegments);
}

// A relief: lines of 0.1 mm over a surface of waves, row by row, at up to 100 mm/s, while a fourth
// axis turns. Through the multi-axis look-ahead with a window of 200 and all its limits; what
// leaves it is not executed.
void MeasureRelief() {
  constexpr int kSegments = 1'000'000;
  constexpr int kRow = 1000;
  std::vector<motion::PathSlot> row;
  motion::Coordinates at{};
  for (int i = 1; i <= kRow; ++i) {
    const double x = 100.0 * (i <= kRow / 2 ? i : kRow - i);
    const motion::Coordinates next = {x, 300 * std::sin(0.031 * i), 900 * std::sin(x / 2100),
                                      40.0 * std::sin(0.02 * i)};
    motion::PathSlot slot;
    slot.is_segment = true;
    slot.segment = *motion::MakeLine(at, next);
    slot.velocity = 100;
    slot.acceleration = 0.8;
    row.push_back(slot);
    at = next;
  }
  motion::PathLimits limits;
  limits.corner_time = 10;
  for (motion::AxisLimits& axis : limits.axes) axis = {90, 0.7, 5};
  size_t left = 0;
  double fastest = 0;
  const double seconds = MeasureCpu([&] {
    motion::CrdFifo fifo;
    fifo.planner.Emplace({.limits = limits, .capacity = 200});
    left = 0;
    for (int i = 0; i < kSegments; ++i) {
      if (!fifo.Append(row[static_cast<size_t>(i % kRow)])) Fail("the FIFO is full");
      for (; !fifo.slots.empty(); fifo.slots.Pop(), ++left) {
        fastest = std::max(fastest, fifo.slots.front().end_velocity);
      }
    }
    fifo.Flush();
    left += fifo.slots.size();
  });
  if (left != kSegments || fastest < 50) Fail("the relief has not been planned");
  std::printf("%-44s %8.1f ns/segment, %.2f million/s\n",
              "1 million segments through the path planner", seconds * 1e9 / kSegments,
              kSegments / seconds * 1e-6);
}

void Accept(const char* command, short code) {
  if (code != 0) Fail(std::string(command) + " = " + std::to_string(code));
}
#define ACCEPT(call) Accept(#call, call)

void PrintCalls(const char* what, int64_t calls, double seconds) {
  std::printf("%-44s %8.1f ns/call\n", what, seconds * 1e9 / static_cast<double>(calls));
}

// Calls from the same process in virtual time: each takes 50 us, so that a cycle passes with every
// fifth.
void MeasureCalls() {
  constexpr int64_t kCalls = 200'000;
  ::setenv("ONCARD_CLOCK", "virtual", 1);
  ACCEPT(GT_Open());
  ACCEPT(GT_AxisOn(1));
  ACCEPT(GT_PrfJog(1));
  TJogPrm jog = {1, 1, 0};
  ACCEPT(GT_SetJogPrm(1, &jog));
  ACCEPT(GT_SetVel(1, 10));
  ACCEPT(GT_Update(1));
  double position = 0;
  PrintCalls("GT_GetPrfPos (50 us pass)", kCalls, MeasureCpu([&] {
               for (int64_t i = 0; i < kCalls; ++i) ACCEPT(GT_GetPrfPos(1, &position));
             }));
  if (position <= 0) Fail("the axis did not move");
  PrintCalls("GT_SetVel (50 us pass)", kCalls, MeasureCpu([&] {
               for (int64_t i = 0; i < kCalls; ++i) ACCEPT(GT_SetVel(1, i % 2 == 0 ? 10 : 11));
             }));
  PrintCalls("GT_Update (1 ms passes)", kCalls, MeasureCpu([&] {
               for (int64_t i = 0; i < kCalls; ++i) ACCEPT(GT_Update(1));
             }));
  ACCEPT(GT_Close());
}

}  // namespace

void BenchMotion() {
  MeasureIdle();
  MeasureTrap();
  MeasureServo();
  MeasureShortWays();
  MeasureBus(motion::DriveKind::kIdeal, "12 axes, bus");
  MeasureBus(motion::DriveKind::kVelocity, "12 axes, bus, velocity drives");
  MeasureOlderCards();
  MeasurePath();
  MeasureRelief();
  MeasureCalls();
}

}  // namespace oncard::bench
