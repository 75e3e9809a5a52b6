// The functions of toml++, compiled here for all sources that include toml_keys.h. The packaged
// library would throw exceptions.
#include <istream>
#include <string>

#ifdef _LIBCPP_HAS_NO_FILESYSTEM
// libc++ declares file streams where there are no files, but does not define them. parse_file() of
// toml++ needs one to compile; nothing calls it.
template <>
class std::basic_ifstream<char> : public std::istream {
 public:
  basic_ifstream() : std::istream(nullptr) {}
  void open(const std::string&, std::ios_base::openmode) {}
  bool is_open() const { return false; }
};
#endif

#define TOML_IMPLEMENTATION
#include "runtime/scenario/file/toml_keys.h"
