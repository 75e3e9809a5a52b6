// The functions of toml++, compiled here for all sources that include toml_keys.h. The packaged
// library would throw exceptions.
#define TOML_IMPLEMENTATION
#include "runtime/scenario/toml_keys.h"
