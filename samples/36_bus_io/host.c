/* Inputs and outputs of a coupler with modules (GTS manual S2, example 5-4): 16 digital inputs at
   byte 14, four analogue inputs at 16, 16 digital outputs at 2, four analogue outputs at 4. */
#include <string.h>

#include "bus.h"

#define SLAVE 0

static unsigned word(const unsigned char* bytes) {
  return (unsigned)bytes[0] | (unsigned)bytes[1] << 8;
}

int main(void) {
  unsigned char input[2];
  unsigned char analog[4];
  unsigned char output[2] = {0x34, 0x12};
  unsigned char analog_outputs[8] = {1, 0, 2, 0, 3, 0, 4, 0};
  unsigned char present[8];
  OpenBus();

  ACCEPTED(GT_EcatIOReadInput(SLAVE, 14, 2, input));
  ACCEPTED(GT_EcatIOReadInput(SLAVE, 20, 4, analog));
  printf("inputs %04X, analogue inputs 3 and 4: %u %u\n", word(input), word(analog),
         word(analog + 2));
  ACCEPTED(GT_EcatIOWriteOutput(SLAVE, 2, 2, output));
  ACCEPTED(GT_EcatIOWriteOutput(SLAVE, 4, 8, analog_outputs));

  /* The same bytes in the process image of the bus, as this is its first slave. */
  ACCEPTED(GT_GetEcatRawData(4, 8, present));
  if (word(input) != 0xA5C3 || word(analog) != 300 || word(analog + 2) != 400) return 1;
  if (memcmp(present, analog_outputs, sizeof present) != 0) return 1;
  ACCEPTED(GT_Close());
  return 0;
}
