// A picture of a trace, as a script for gnuplot with the data inside: position, velocity,
// acceleration and following error over time, variables and digital signals as steps, the states of
// drives by their names, and the path of every coordinate system. The same trace gives the same
// script, and the same version of gnuplot the same bytes of SVG. The caller runs gnuplot. Tested by
// tests/runtime/plot_test.cc.
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"
#include "runtime/observe/trace.h"

namespace oncard::runtime {

enum class PictureFormat : uint8_t { kSvg, kPng };

struct PlotOptions {
  std::string title;
  PictureFormat format = PictureFormat::kSvg;
};

/// The script, with which gnuplot writes the picture to its standard output. Fails if nothing in
/// the trace changes.
Result<std::string> PlotScript(const Trace& trace, const PlotOptions& options);

}  // namespace oncard::runtime
