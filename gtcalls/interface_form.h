// The form of a family's C interface, beyond its catalogue: the input of the generator of the
// header and of the entry points (generate_interface.cc).
#pragma once

#include <span>
#include <string_view>

#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

/// Commands that a header of their own declares: the vendor delivers them as a module.
struct HeaderModule {
  std::string_view file;   ///< its name without .h
  std::string_view topic;  ///< of its commands in the catalogue
  std::string_view head;   ///< the header up to its structures
  std::span<const std::string_view> structures;
};

/// A topic in Chinese.
struct TopicTitle {
  std::string_view topic;
  std::string_view zh;
};

/// The title of a topic, or a note on the one before it.
struct TopicLine {
  std::string_view topic;
  std::string_view note;
};

struct InterfaceForm {
  const Catalogue& catalogue;
  /// The function that returns the catalogue, and the file that declares it.
  std::string_view catalogue_function;
  std::string_view catalogue_file;
  /// The header without .h.
  std::string_view header;
  /// The macro at the beginning of a prototype.
  std::string_view api;
  /// The prefix of all other macros.
  std::string_view macro_prefix;
  /// The prefix of command names.
  std::string_view command_prefix;
  /// The header up to its constants.
  std::string_view head;

  // Parts that a family need not have.

  /// Topics of the catalogue with notes on them, for the documentation.
  std::span<const TopicLine> topics = {};
  /// The page of the commands up to its first topic.
  std::string_view page_head = {};
  /// The same in Chinese, and the titles of the topics, for a page that says what each command
  /// does.
  std::string_view page_head_zh = {};
  std::span<const TopicTitle> topics_zh = {};
  /// As `api`, with the type that a command returns in place of its code as the macro's argument.
  std::string_view api_returning = {};
  /// Inline functions for C++ after the prototypes: other spellings of hosts.
  std::string_view overloads = {};
  /// Functions with a card number: they have this prefix. The macro that ends with MULTI_CARD is
  /// the switch to them.
  std::string_view multi_card_prefix = {};
  /// Structures with another layout in the vendor's basic header, and the prefix of the functions
  /// that take them in ours.
  std::span<const Structure> basic_layouts = {};
  std::string_view wide_prefix = {};
  /// The module whose header includes the main one.
  const HeaderModule* module = nullptr;
  /// Types of the declarations for C# that are no structures of the catalogue, as they are written
  /// inside of the class.
  std::string_view csharp_types = {};

  /// The spelling of scalar types: that of the compiler's `long`, unless the generator changes it.
  std::string_view (*spell)(Scalar scalar) = SpellScalar;
};

/// Those of the families that a generator knows, defined beside its list of families.
std::span<const InterfaceForm* const> InterfaceForms();

}  // namespace oncard::gtcalls
