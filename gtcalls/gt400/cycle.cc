#include "gtcalls/gt400/cycle.h"

#include "gtcalls/gt400/breakpoints.h"
#include "gtcalls/gt400/homing.h"
#include "gtcalls/gt400/interrupts.h"
#include "gtcalls/gt400/paths.h"
#include "gtcalls/gt400/registers.h"
#include "gtcalls/gt400/stops.h"

namespace oncard::gtcalls::gt400 {

// The order is part of what a program can see. The plans that begin here begin at this instant.
void AfterTick(Card& card) {
  NoticeStops(card);
  AdvancePath(card);
  NoticeEnds(card);
  MeetBreakpoints(card);
  ApplyTakenUpdates(card);
  BeginTakenHomings(card);
  RequestInterrupt(card);
}

// An input can become active in any cycle.
int64_t CyclesBeforeAct(const CardView&) { return 0; }

}  // namespace oncard::gtcalls::gt400
