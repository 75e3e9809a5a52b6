// Searches of `oncard explore` that live in files: interrupted ones, parts, and whole ones put
// together from parts.
#pragma once

#include <string>
#include <vector>

#include "explore/reports/report.h"
#include "explore/search/kept_search.h"
#include "explore/search/search_file.h"
#include "tools/explore_subject.h"
#include "tools/session.h"

namespace oncard::tools {

/// Reads a search file and what it explores, which must still be the same. Gives the exit code.
int ReadSearch(const Session& session, const std::string& path, bool json,
               explore::SearchFile* file, ExploreSubject* subject);

/// Reads the files of parts and puts them together. Gives the exit code.
int MergeSearches(const Session& session, const std::vector<std::string>& paths, bool json,
                  explore::SearchFile* file, ExploreSubject* subject);

/// A search of which nothing is done yet, to be kept in `path`. Fails when the engine's searches
/// cannot be kept, the program needs its card, or its path is not UTF-8.
Result<explore::SearchFile> BeginSearch(const ExploreSubject& subject, const std::string& input,
                                        const std::string& path, const explore::SearchPart& part,
                                        const explore::ExploreOptions& options);

/// Goes on with a search (explore/search/kept_search.h); `file` is then what is to be kept.
Result<explore::Findings> GoOn(const ExploreSubject& subject,
                               const explore::ExploreOptions& options,
                               const explore::SearchKeeper& keep, explore::SearchFile* file);

/// What a file's parts have found.
Result<explore::Findings> ConcludeSearch(const ExploreSubject& subject,
                                         const explore::SearchFile& file);

/// The same search as a file at another place would hold it. Fails when that cannot name what it
/// explores.
Result<void> MoveSearch(const std::string& from, const std::string& to, explore::SearchFile* file);

}  // namespace oncard::tools
