// The functions that the module exports, for web/engine/engine_module.js. A request is written to
// memory of the module, and its answer is read there:
//
//   oncard_request(size)  memory for a request; nullptr if a request may not be that large
//   oncard_handle()       handles the request that was written there; the size of the answer
//   oncard_answer()       where the answer is, until the next request
//   oncard_version()      the version of the project, ending in a NUL
//
// Tested by tests/web/module_test.mjs.
#include <cstddef>
#include <string>

#include "base/limits.h"
#include "web/wasm/module_host.h"
#include "web/wasm/module_parts.h"

namespace {

oncard::web::ModuleHost host(oncard::web::RecordReader(), oncard::web::ExplorerOfModule());
std::string request;
std::string answer;

}  // namespace

#define ONCARD_EXPORT(name) __attribute__((export_name(#name))) name

extern "C" {

char* ONCARD_EXPORT(oncard_request)(size_t size) {
  if (size > oncard::kRequestKind.bytes_max) return nullptr;
  request.resize(size);
  return request.data();
}

size_t ONCARD_EXPORT(oncard_handle)() {
  answer = host.Handle(request);
  request = {};
  return answer.size();
}

const char* ONCARD_EXPORT(oncard_answer)() { return answer.data(); }

const char* ONCARD_EXPORT(oncard_version)() { return ONCARD_VERSION; }

}  // extern "C"
