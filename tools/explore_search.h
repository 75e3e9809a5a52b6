// Searches of `oncard explore` that are stored in files: interrupted ones, parts, and searches
// merged from parts.
#pragma once

#include <string>
#include <vector>

#include "explore/reports/report.h"
#include "explore/search/kept_search.h"
#include "explore/search/search_file.h"
#include "tools/explore_subject.h"
#include "tools/invocation.h"

namespace oncard::tools {

/// Reads a search file and the program that it explores, which must be unchanged. Returns the exit
/// code.
int ReadSearch(const Invocation& invocation, const std::string& path, SubjectReading reading,
               explore::SearchFile* file, ExploreSubject* subject);

/// Reads the files of parts and merges them; `incomplete` are those that must be continued. Returns
/// the exit code.
int MergeSearches(const Invocation& invocation, const std::vector<std::string>& paths,
                  SubjectReading reading, explore::SearchFile* file, ExploreSubject* subject,
                  std::vector<std::string>* incomplete);

/// A new search, to be saved in `path`. Fails if searches of the engine cannot be saved, as
/// BeginKept() (explore/kept_exploration.h), or if its path is not UTF-8.
Result<explore::SearchFile> BeginSearch(const ExploreSubject& subject, const std::string& input,
                                        const std::string& path, const explore::SearchPart& part,
                                        const explore::ExploreOptions& options);

/// Continues a search (explore/search/kept_search.h); `file` is then the search to be saved.
Result<explore::Findings> GoOn(const ExploreSubject& subject,
                               const explore::ExploreOptions& options,
                               const explore::SearchKeeper& keep, explore::SearchFile* file);

/// The results of the parts in a file.
Result<explore::Findings> ConcludeSearch(const ExploreSubject& subject,
                                         const explore::ExploreOptions& options,
                                         const explore::SearchFile& file);

/// The same search for a file with another path. Fails if that file cannot refer to the explored
/// program.
Result<void> MoveSearch(const std::string& from, const std::string& to, explore::SearchFile* file);

}  // namespace oncard::tools
