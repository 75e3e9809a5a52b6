// Files of requests to a module and of the answers to them, for the tests in Node.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace oncard::web {

/// Writes the requests, one in each line, and the answers of this computer's build of the module
/// whose RecordReader() is linked. The exit code of the command; standard error says why a file
/// cannot be written.
int WriteRequests(const std::vector<nlohmann::ordered_json>& requests,
                  const std::string& requests_path, const std::string& answers_path);

}  // namespace oncard::web
