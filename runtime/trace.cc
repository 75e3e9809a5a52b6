#include "runtime/trace.h"

#include <bitset>

namespace oncard::runtime {
namespace {

// Identifier codes of a VCD are made of the printable characters ! to ~.
constexpr int kVcdFirst = '!';
constexpr int kVcdCount = '~' - '!' + 1;

std::string VcdCode(size_t index) {
  std::string code;
  do {
    code += static_cast<char>(kVcdFirst + static_cast<int>(index % kVcdCount));
    index /= kVcdCount;
  } while (index != 0);
  return code;
}

std::string FormatMs(int64_t microseconds) {
  return fmt::format("{}", static_cast<double>(microseconds) / 1000);
}

std::string VcdChange(double value, vm::DataType type, const std::string& code) {
  if (type == vm::DataType::kDouble) {
    return fmt::format("r{} {}\n", FormatNumber(value, type), code);
  }
  const auto bits = std::bitset<32>(static_cast<uint32_t>(static_cast<int64_t>(value)));
  return fmt::format("b{} {}\n", bits.to_string(), code);
}

}  // namespace

TraceRow Trace::Row(const Controller& controller) const {
  TraceRow row;
  row.time_us = controller.cycle() * controller.options().motion.cycle_us;
  for (const Quantity& column : columns_) row.values.push_back(ReadQuantity(column, controller));
  return row;
}

void Trace::Sample(const Controller& controller) {
  TraceRow row = Row(controller);
  if (rows_.empty()) {
    for (const Quantity& column : columns_) types_.push_back(TypeOfQuantity(column, controller));
  } else if (rows_.back().values == row.values) {
    return;
  }
  rows_.push_back(std::move(row));
}

void Trace::Finish(const Controller& controller) {
  Sample(controller);
  TraceRow row = Row(controller);
  if (rows_.back().time_us != row.time_us) rows_.push_back(std::move(row));
}

std::string Trace::Csv() const {
  std::string text = "time_ms";
  for (const Quantity& column : columns_) text += ',' + column.name;
  text += '\n';
  for (const TraceRow& row : rows_) {
    text += FormatMs(row.time_us);
    for (size_t i = 0; i < row.values.size(); ++i) {
      text += ',' + FormatNumber(row.values[i], types_[i]);
    }
    text += '\n';
  }
  return text;
}

std::string Trace::Vcd() const {
  std::string text = "$timescale 1 us $end\n$scope module oncard $end\n";
  for (size_t i = 0; i < columns_.size() && i < types_.size(); ++i) {
    const bool real = types_[i] == vm::DataType::kDouble;
    text += fmt::format("$var {} {} {} $end\n", real ? "real 64" : "wire 32", VcdCode(i),
                        columns_[i].name);
  }
  text += "$upscope $end\n$enddefinitions $end\n";
  const TraceRow* before = nullptr;
  for (const TraceRow& row : rows_) {
    text += fmt::format("#{}\n", row.time_us);
    for (size_t i = 0; i < row.values.size(); ++i) {
      if (before != nullptr && before->values[i] == row.values[i]) continue;
      text += VcdChange(row.values[i], types_[i], VcdCode(i));
    }
    before = &row;
  }
  return text;
}

std::string Trace::Json() const {
  std::vector<std::string> names;
  for (const Quantity& column : columns_) names.push_back(fmt::format("\"{}\"", column.name));
  std::vector<std::string> rows;
  for (const TraceRow& row : rows_) {
    std::string line = fmt::format("[{}", FormatMs(row.time_us));
    for (size_t i = 0; i < row.values.size(); ++i) {
      line += ',' + FormatNumber(row.values[i], types_[i]);
    }
    rows.push_back(line + ']');
  }
  return fmt::format("{{\"time_unit\":\"ms\",\"columns\":[{}],\"rows\":[\n{}\n]}}\n",
                     fmt::join(names, ","), fmt::join(rows, ",\n"));
}

}  // namespace oncard::runtime
