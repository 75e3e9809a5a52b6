#include "web/wasm/module_host.h"

#include <vector>

#include "base/json_text.h"
#include "base/message.h"

namespace oncard::web {
namespace {

using session::Json;

/// The arguments of a request to explore; nullptr for any other request.
const Json* ArgumentsOfExplore(const Json& request) {
  static const Json none = Json::object();
  if (!request.is_object()) return nullptr;
  const auto name = request.find("request");
  if (name == request.end() || *name != "explore") return nullptr;
  const auto arguments = request.find("arguments");
  return arguments == request.end() ? &none : &*arguments;
}

Error NoExplorer() {
  return MakeError(1, "this module searches no interleavings: oncard-full.wasm does",
                   "此模块不搜索交错：oncard-full.wasm 可以");
}

}  // namespace

std::string ModuleHost::Handle(std::string_view text) {
  if (text.find("explore") == std::string_view::npos) return session_.Handle(text);
  // The session reads its own requests, and says what is wrong with them.
  const Json request = Json::parse(text, nullptr, false);
  const Json* arguments = ArgumentsOfExplore(request);
  if (arguments == nullptr) return session_.Handle(text);
  Language language = Language::kEnglish;
  std::vector<std::string> missing;
  const auto answer = explorer_ != nullptr ? explorer_(*arguments, &language, &missing)
                                           : Result<Json>(NoExplorer());
  const auto id = request.find("id");
  Json response = {{"id", id == request.end() ? Json() : *id}, {"ok", answer.ok()}};
  if (answer.ok()) {
    response["result"] = answer.value();
  } else {
    response["error"] = answer.error().message.In(language);
  }
  if (!missing.empty()) response["missing"] = missing;
  return JsonText(response) + '\n';
}

}  // namespace oncard::web
