#include "moving_program.h"

#include <fmt/core.h>

#include <random>

namespace oncard::web {
namespace {

class Maker {
 public:
  explicit Maker(uint64_t seed) : random_(seed) {}

  MovingProgram Make() {
    MovingProgram program;
    program.threads = static_cast<int>(Between(1, 4));
    program.source = "TTrapPrm trap;\nTJogPrm jog;\nint turns;\ndouble places[4];\n";
    for (thread_ = 0; thread_ < program.threads; ++thread_) program.source += Function();
    return program;
  }

 private:
  int64_t Between(int64_t least, int64_t largest) {
    return least + static_cast<int64_t>(random_() % static_cast<uint64_t>(largest - least + 1));
  }

  int axis() const { return thread_ + 1; }

  std::string Function() {
    std::string body;
    for (int64_t part = Between(2, 6); part > 0; --part) {
      switch (Between(0, 4)) {
        case 0:
          body += Trap();
          break;
        case 1:
          body += Jog();
          break;
        case 2:
          body += Gear();
          break;
        case 3:
          body += Wait();
          break;
        default:
          body += SwitchOutput();
      }
    }
    return fmt::format(
        "int f{0}(int left)\n{{\n  int clock;\n  int far;\n  double place;\n  GT_AxisOn({1});\n"
        "{2}  return turns;\n}}\n",
        thread_, axis(), body);
  }

  /// Usually brings the axis to rest, before its mode changes.
  std::string Rest() {
    if (Between(0, 2) == 0) return {};
    return fmt::format("  GT_Stop({}, 0);\n  GT_Delay({});\n", 1 << thread_, Between(10, 60));
  }

  std::string Trap() {
    return Rest() +
           fmt::format(
               "  GT_PrfTrap({0});\n  trap.acc = 0.{1};\n  trap.dec = 0.{2};\n  trap.velStart = "
               "0;\n"
               "  trap.smoothTime = {3};\n  GT_SetTrapPrm({0}, &trap);\n  GT_SetPos({0}, {4});\n"
               "  GT_SetVel({0}, {5});\n  GT_Update({0});\n",
               axis(), Between(1, 99), Between(1, 99), Between(0, 50), Between(-3000, 3000),
               Between(1, 60));
  }

  std::string Jog() {
    return Rest() +
           fmt::format(
               "  GT_PrfJog({0});\n  jog.acc = 0.{1};\n  jog.dec = 0.{2};\n  jog.smooth = 0.{3};\n"
               "  GT_SetJogPrm({0}, &jog);\n  GT_SetVel({0}, {4});\n  GT_Update({0});\n  "
               "GT_Delay({5});\n"
               "  GT_Stop({6}, 0);\n",
               axis(), Between(1, 99), Between(1, 99), Between(0, 9), Between(-50, 50),
               Between(1, 30), 1 << thread_);
  }

  /// Follows the next axis, which another thread may move.
  std::string Gear() {
    return Rest() + fmt::format(
                        "  GT_PrfGear({0}, 0);\n  GT_SetGearMaster({0}, {1}, 2, 0);\n"
                        "  GT_SetGearRatio({0}, {2}, {3}, {4});\n  GT_GearStart({5});\n",
                        axis(), axis() % 4 + 1, Between(1, 5), Between(1, 5), Between(2, 900),
                        1 << thread_);
  }

  /// Counts until the axis has passed a place, or a number of times.
  std::string Wait() {
    return fmt::format(
        "  left = {0};\nlbl_{1}:\n  GT_GetPrfPos({2}, &place, 1, &clock);\n"
        "  places[{3}] = places[{3}] + place;\n  turns = turns + 1;\n  left = left - 1;\n"
        "  far = place < {4};\n  far = far && left;\n  if (far) goto lbl_{1};\n",
        Between(1, 400), labels_++, axis(), thread_, Between(-2000, 2000));
  }

  std::string SwitchOutput() {
    return fmt::format("  GT_SetDoBit(12, {}, {});\n  GT_Delay({});\n", Between(1, 16),
                       Between(0, 1), Between(1, 9));
  }

  std::mt19937_64 random_;
  int thread_ = 0;
  int labels_ = 0;
};

}  // namespace

MovingProgram MakeMovingProgram(uint64_t seed) { return Maker(seed).Make(); }

}  // namespace oncard::web
