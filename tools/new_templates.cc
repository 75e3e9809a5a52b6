#include "tools/new_templates.h"

#include <array>

namespace oncard::tools {

std::span<const NewTemplate> NewTemplates() {
  static constexpr auto kTemplates = std::to_array<NewTemplate>({
#include "new_templates.inc"
  });
  return kTemplates;
}

}  // namespace oncard::tools
