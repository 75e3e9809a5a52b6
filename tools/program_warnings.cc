#include "tools/program_warnings.h"

namespace oncard::tools {

std::vector<Message> ProgramWarnings(const explore::Findings& findings,
                                     const runtime::CardWarnings& silent,
                                     const std::string& program_path) {
  std::vector<Message> warnings;
  for (const runtime::RefusedCommand& refused : findings.refused) {
    warnings.push_back(runtime::DescribeRefusedPlace(refused, program_path));
  }
  for (const runtime::CardFinding& finding : findings.card) {
    if (silent.Has(finding.warning)) continue;
    warnings.push_back(runtime::DescribeFindingPlace(finding, program_path));
  }
  return warnings;
}

}  // namespace oncard::tools
