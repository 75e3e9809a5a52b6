#include "tests/web/request_files.h"

#include <iostream>

#include "base/files.h"
#include "base/json_text.h"
#include "web/wasm/exploration.h"
#include "web/wasm/module_host.h"
#include "web/wasm/module_parts.h"

namespace oncard::web {

int WriteRequests(const std::vector<nlohmann::ordered_json>& requests,
                  const std::string& requests_path, const std::string& answers_path) {
  ModuleHost host(RecordReader(), Explore);
  std::string lines;
  std::string answers;
  for (const auto& request : requests) {
    const std::string text = JsonText(request);
    lines += text + '\n';
    answers += host.Handle(text);
  }
  auto written = WriteFileAtomically(requests_path, lines);
  if (written.ok()) written = WriteFileAtomically(answers_path, answers);
  if (!written.ok()) std::cerr << written.error().message.en << '\n';
  return written.ok() ? 0 : 1;
}

}  // namespace oncard::web
