// Programs with a card in each of which something matters to searches of its states.
#pragma once

#include <vector>

namespace oncard::explore {

struct CardMachine {
  const char* name;
  const char* source;  ///< as for CardOf()
  const char* keys;
};

const std::vector<CardMachine>& CardMachines();

}  // namespace oncard::explore
