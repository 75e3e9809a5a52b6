// A host with the vendor's gts.h in its folder, as when a Windows project is copied: this header is
// included instead of ours. Its structures must be read and written with its layout.
#include <Windows.h>

#include "gts.h"

#include "check.h"

// A structure and the memory after it in the host.
template <typename T>
struct Guarded {
  T value;
  unsigned char behind[64];

  Guarded() { memset(this, 0x5A, sizeof *this); }
  void Check() const {
    for (unsigned char byte : behind) CHECK_EQ(byte, 0x5A);
  }
};

static void Triggers() {
  TTrigger trigger = {2, CAPTURE_HOME, 3, 40, 1, -1000000, 2000000};
  Guarded<TTrigger> read;
  ACCEPTED(GT_SetTrigger(1, &trigger));
  ACCEPTED(GT_GetTrigger(1, &read.value));
  read.Check();
  CHECK_EQ(read.value.encoder, 2);
  CHECK_EQ(read.value.probeType, CAPTURE_HOME);
  CHECK_EQ(read.value.probeIndex, 3);
  CHECK_EQ(read.value.offset, 40);
  CHECK_EQ(read.value.windowOnly, 1);
  CHECK_EQ(read.value.firstPosition, -1000000);
  CHECK_EQ(read.value.lastPosition, 2000000);
  CHECK_EQ(GT_SetTrigger(1, NULL), 7);
  CHECK_EQ(GT_GetTrigger(1, NULL), 7);
  CHECK_EQ(GT_SetTrigger(0, &trigger), 7);
}

static void Segments() {
  TCrdPrm crd;
  double position[2] = {0, 0};
  short run = 1;
  long segment = 0;
  Guarded<TCrdData> line;

  memset(&crd, 0, sizeof crd);
  crd.dimension = 2;
  crd.profile[0] = 1;
  crd.profile[1] = 2;
  crd.synVelMax = 500;
  crd.synAccMax = 1;
  crd.setOriginFlag = 1;
  ACCEPTED(GT_SetCrdPrm(1, &crd));

  memset(&line.value, 0, sizeof line.value);
  line.value.pos[0] = 3000;
  line.value.pos[1] = -4000;
  line.value.vel = 50;
  line.value.acc = 1;
  line.value.velEndZero = 1;
  ACCEPTED(GT_CrdData(1, &line.value));
  line.Check();
  ACCEPTED(GT_CrdData(1, NULL));
  ACCEPTED(GT_CrdStart(1, 0));
  for (int look = 0; run == 1 && look < 10000; ++look) {
    ACCEPTED(GT_CrdStatus(1, &run, &segment));
  }
  ACCEPTED(GT_GetCrdPos(1, position));
  CHECK_EQ(position[0], 3000);
  CHECK_EQ(position[1], -4000);
}

int main() {
  ACCEPTED(GT_Open());
  ACCEPTED(GT_Reset());
  ACCEPTED(GT_ClrSts(1, 4));
  for (short axis = 1; axis <= 4; ++axis) ACCEPTED(GT_AxisOn(axis));
  CHECK_EQ(sizeof(TTrigger), sizeof(long) == 8 ? 32 : 20);
  Triggers();
  Segments();
  ACCEPTED(GT_Close());
  return 0;
}
