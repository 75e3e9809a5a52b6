/* Counts its runs in word 7 of the memory that survives power-off, and shows what it has found:
   `memory END` with END one of
     close   the host closes the card
     leave   the host ends without doing so
     abort   it is killed before
     child   a child of fork() closes the card, its parent does not change it
     late    a child closes the card, without a call before, after its parent has
     twice   the card is closed and opened again, then counted once more
     second  card 1 instead of 0 */
#define GTS_MULTI_CARD
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"
#include "gts.h"

static void transfer(short card, short mode) {
  short done = 0;
  ACCEPTED(GT_StartAccessMRAM(card, 0, 16, mode));
  while (done == 0) ACCEPTED(GT_GetMRAMStatus(card, &done));
}

static void count(short card) {
  short word = 0;
  transfer(card, 0);
  ACCEPTED(GT_GetMRAMData(card, 7, &word, 1));
  printf("%d\n", word);
  fflush(stdout);
  ++word;
  ACCEPTED(GT_SetMRAMData(card, 7, &word, 1));
  transfer(card, 1);
}

static int close_before_a_child(short card) {
  int closed[2];
  char none;
  int status = -1;
  CHECK_EQ(pipe(closed), 0);
  if (fork() == 0) {
    close(closed[1]);
    CHECK_EQ(read(closed[0], &none, 1), 0);
    ACCEPTED(GT_Close(card));
    return 0;
  }
  count(card);
  ACCEPTED(GT_Close(card));
  close(closed[1]);
  wait(&status);
  return status;
}

int main(int argc, char** argv) {
  const char* end = argc > 1 ? argv[1] : "close";
  const short card = strcmp(end, "second") == 0 ? 1 : 0;
  short code = GT_Open(card, 0, 1);
  if (code != 0) {
    printf("GT_Open = %d\n", code);
    return 3;
  }
  if (strcmp(end, "late") == 0) return close_before_a_child(card);
  if (strcmp(end, "child") == 0) {
    pid_t child = fork();
    if (child != 0) {
      waitpid(child, NULL, 0);
      return 0;
    }
  }
  count(card);
  if (strcmp(end, "abort") == 0) _exit(0);
  if (strcmp(end, "leave") == 0) return 0;
  ACCEPTED(GT_Close(card));
  if (strcmp(end, "twice") != 0) return 0;
  ACCEPTED(GT_Open(card, 0, 1));
  count(card);
  ACCEPTED(GT_Close(card));
  return 0;
}
