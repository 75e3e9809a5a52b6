// How wide what is printed may be.
#pragma once

namespace oncard::tools {

/// Columns of standard output: those of the variable COLUMNS if it says at least 40, or else of the
/// terminal; 0 when it is none.
int OutputWidth();

}  // namespace oncard::tools
