// How the C interface of a family looks, beyond what its catalogue says: what the generator of the
// header and of the entry points must be told (generate_interface.cc).
#pragma once

#include <span>
#include <string_view>

#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

struct InterfaceForm {
  const Catalogue& catalogue;
  /// The function that gives the catalogue, in the header catalogue.h of the family's folder.
  std::string_view catalogue_function;
  /// The macro that begins a prototype.
  std::string_view api;
  /// Begins the names of all other macros. The one that ends in MULTI_CARD is the switch to several
  /// cards.
  std::string_view macro_prefix;
  /// Begins the names of commands, and what stands there instead in the names of the functions with
  /// a card number, and of those that take a structure which `basic_layouts` has as well.
  std::string_view command_prefix;
  std::string_view multi_card_prefix;
  std::string_view wide_prefix;
  /// The header up to its constants.
  std::string_view head;
  /// The header behind the names with a card number: the end of the switch, with #else.
  std::string_view one_card;
  /// Structures that the vendor's basic header lays out otherwise.
  std::span<const Structure> basic_layouts;
};

}  // namespace oncard::gtcalls
