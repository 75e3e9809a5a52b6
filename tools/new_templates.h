// The files of tools/new, from which `oncard new` makes a project.
#pragma once

#include <span>
#include <string_view>

namespace oncard::tools {

struct NewTemplate {
  std::string_view name;  ///< of the file in tools/new
  std::string_view text;
};

std::span<const NewTemplate> NewTemplates();

}  // namespace oncard::tools
