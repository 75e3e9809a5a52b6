// gts.h with a card number, in C++: the default arguments remain, and the functions differ from
// those for one card, so that both can be used in one program. Only compiled.
#include <type_traits>

#include "gts_multi.h"

// After gts_multi.h, from which it takes the card numbers.
#include "LookAheadEx.h"

static_assert(std::is_same_v<decltype(GT_Close), short(short)>);
static_assert(std::is_same_v<decltype(GT_SetPos), short(short, short, long)>);
static_assert(std::is_same_v<decltype(GT_Download), short(short, const char*)>);
static_assert(std::is_same_v<decltype(&GTM_SetPos), decltype(&GT_SetPos)>);

// The functions for one card do not exist here and cannot be called by mistake.
short CallCommandsOfCards();
short CallCommandsOfCards() {
  double position = 0;
  const short code = GT_Open(3);
  return code != 0 ? code : GT_GetPrfPos(3, 1, &position);
}

static_assert(std::is_same_v<decltype(GT_SetupLookAheadCrd), short(short, short, EMachineMode)>);
static_assert(std::is_same_v<decltype(&GTM_CrdDataEx), decltype(&GT_CrdDataEx)>);

short CallLookAheadOfCards();
short CallLookAheadOfCards() {
  TLookAheadParameter parameter{};
  const short code = GT_InitLookAheadEx(3, 1, &parameter);
  return code != 0 ? code : GT_LnXYEx(3, 1, 8, 9, 100, 800, 0, 0);
}
