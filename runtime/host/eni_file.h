// EtherCAT network information files (ENI, ETG.2100), such as Gecat.eni: the slaves of a bus with
// their identities and process data. Of a slave the reader takes VendorId and ProductCode of Info,
// and the RxPdo and TxPdo of ProcessData that have a sync manager (`Sm`), or all if none has.
// Numbers are `17`, `#x11` or `0x11`, also in CDATA. PhysAddr and the lengths of Send and Recv are
// checked. Other elements are for masters that send frames, and are not read.
//
// A slave whose outputs contain 6040h is a drive; drives are axes 1, 2 ... in the order of the file
// (assumption). Objects that a simulated drive does not have, and those of more than 32 bits, are
// gaps in the process data. Files are untrusted: sizes, numbers and lengths are checked. Tested by
// tests/runtime/eni_file_test.cc.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "motion/bus/slaves.h"

namespace oncard::runtime {

/// The name of the file in the folder of a host program (GTS manual S2, 5.2.2.1).
inline constexpr std::string_view kEniName = "Gecat.eni";

/// Reads the text of a file; `path` names it in errors: `Gecat.eni:3:5: what`.
Result<motion::bus::Slaves> ParseEni(std::string_view text, const std::string& path);

/// The text of a file that ParseEni() reads back. Objects have no names.
std::string FormatEni(const motion::bus::Slaves& slaves);

}  // namespace oncard::runtime
