// isa.c in C++, where GT_Open is overloaded. Handlers may be what they are for compilers for DOS;
// it is enough that this compiles.
#include "isa.c"

namespace {

void OnInterrupt(...) {}

[[maybe_unused]] void Hook() {
  const GT_ISR before = GT_HookIsr(OnInterrupt);
  GT_HookIsr(NULL);
  GT_UnhookIsr(before);
}

}  // namespace
