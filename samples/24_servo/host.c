/* A servo axis in closed loop: a proportional controller outputs the voltage of the motor. The axis
   moves forward without velocity feed-forward and back with it. */
#include "accepted.h"
#include "gts.h"

#define AXIS 1
#define CLOSED_LOOP 0
#define IN_POSITION 0x800 /* bit 11 of the status word */

static void MoveTo(long position) {
  long status = 0;
  ACCEPTED(GT_SetPos(AXIS, position));
  ACCEPTED(GT_Update(1 << (AXIS - 1)));
  do {
    ACCEPTED(GT_GetSts(AXIS, &status, 1, NULL));
  } while (!(status & IN_POSITION));
}

int main(void) {
  TTrapPrm trap = {0.1, 0.1, 0, 0};
  TPid pid;
  ACCEPTED(GT_Open(0, 1));
  ACCEPTED(GT_CtrlMode(AXIS, CLOSED_LOOP));
  ACCEPTED(GT_GetPid(AXIS, 1, &pid));
  pid.kp = 20;
  ACCEPTED(GT_SetPid(AXIS, 1, &pid));
  ACCEPTED(GT_SetAxisBand(AXIS, 3, 400)); /* within 3 pulses for 100 ms */
  ACCEPTED(GT_AxisOn(AXIS));
  ACCEPTED(GT_PrfTrap(AXIS));
  ACCEPTED(GT_SetTrapPrm(AXIS, &trap));
  ACCEPTED(GT_SetVel(AXIS, 10));
  MoveTo(5000);
  pid.kvff = 327.67;
  ACCEPTED(GT_SetPid(AXIS, 1, &pid));
  MoveTo(0);
  ACCEPTED(GT_Close());
  return 0;
}
