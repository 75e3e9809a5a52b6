// A search for which the user named no file. It is saved all the same if it takes long or a signal
// ends it. Tested by tests/tools/explore_search_test.cc.
#pragma once

#include <optional>
#include <string>

#include "explore/search/explorer.h"
#include "explore/search/search_file.h"
#include "tools/explore_subject.h"
#include "tools/invocation.h"

namespace oncard::tools {

class UnnamedSearch {
 public:
  /// A search of the file `input`. The invocation must outlive this object.
  UnnamedSearch(const Invocation& invocation, const std::string& input,
                const ExploreSubject& subject, const explore::ExploreOptions& options);

  /// True if the search of traces will be run, which can be saved.
  bool searches_traces() const { return searches_traces_; }

  /// Saves what is known so far. Returns the exit code.
  int Keep(const explore::TraceSearch& search);

  /// To be called at the end of the search: saves what is left to be searched, or removes the file
  /// of a search that is complete. Returns the exit code.
  int End(const explore::Exploration& found, bool interrupted);

 private:
  const Invocation& invocation_;
  std::string path_;
  std::optional<explore::SearchFile> file_;
  std::optional<Message> why_not_;  ///< why the search cannot be saved
  bool searches_traces_ = false;
  bool kept_ = false;
};

}  // namespace oncard::tools
