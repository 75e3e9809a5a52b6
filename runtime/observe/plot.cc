#include "runtime/observe/plot.h"
#include "base/milliseconds.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace oncard::runtime {
namespace {

// Sizes in pixels.
constexpr int kTimeWidth = 960;
constexpr int kPathWidth = 520;
constexpr int kLeftMargin = 132;
constexpr int kLegendWidth = 150;
constexpr int kTitleHeight = 46;
constexpr int kFooterHeight = 54;
constexpr int kGap = 16;
constexpr int kCurveHeight = 168;
constexpr int kSignalHeight = 26;
constexpr int kPathMargin = 86;
constexpr int kPathHeightMin = 400;

// A curve is simplified by removing points as long as it deviates by no more than this fraction of
// its range.
constexpr double kSimplification = 1.0 / 4000;
// Free space above and below curves, as a fraction of the range.
constexpr double kPadding = 0.07;
// The high level of a signal; the distance between two signals is 1.
constexpr double kSignalLevel = 0.7;

// Colours that people with any colour vision can distinguish (Okabe and Ito, 2008), dark ones
// first.
constexpr std::array<std::string_view, 7> kColors = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                     "#E69F00", "#56B4E9", "#000000"};

struct Point {
  double x = 0;
  double y = 0;
};

struct Curve {
  std::string name;
  std::vector<Point> points;
  bool steps = false;
  size_t color = 0;
  int dash = 0;  ///< 0: solid; others distinguish curves with the same colour in a panel
  std::string unit = {};
};

struct Range {
  double low = 0;
  double high = 0;

  double size() const { return high - low; }
  void Include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

struct Panel {
  std::string label = {};
  std::vector<Curve> curves = {};
  bool signals = false;                          // stacked, one row each
  std::span<const std::string_view> names = {};  // of the values
  bool measures = false;                         // along axes: each curve has a unit
};

struct Path {
  std::string label_x;
  std::string label_y;
  Curve curve;
};

// The place of a panel, in fractions of the picture, from below.
struct Box {
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
};

std::string Number(double value) { return fmt::format("{:.9g}", value + 0.0); }

// A gnuplot string without substitutions.
std::string GnuplotString(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') quoted += c;
    quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted + "'";
}

Range RangeOf(const std::vector<Point>& points) {
  Range range{points.front().y, points.front().y};
  for (const Point& point : points) range.Include(point.y);
  return range;
}

// Removes points close to the straight line through their neighbours ("swinging door").
std::vector<Point> Simplify(const std::vector<Point>& points) {
  const double tolerance = RangeOf(points).size() * kSimplification;
  std::vector<Point> kept = {points.front()};
  Point last = points.front();
  double lowest = -HUGE_VAL;
  double highest = HUGE_VAL;
  const auto rise = [&](double y, double x) { return (y - kept.back().y) / (x - kept.back().x); };
  for (size_t i = 1; i < points.size(); ++i) {
    const Point& point = points[i];
    const double slope = rise(point.y, point.x);
    if (slope < lowest || slope > highest) {
      kept.push_back(last);
      lowest = -HUGE_VAL;
      highest = HUGE_VAL;
    }
    lowest = std::max(lowest, rise(point.y - tolerance, point.x));
    highest = std::min(highest, rise(point.y + tolerance, point.x));
    last = point;
  }
  if (points.size() > 1) kept.push_back(last);
  return kept;
}

// Only the points at which the value changes, and the last one.
std::vector<Point> Changes(const std::vector<Point>& points) {
  std::vector<Point> kept;
  for (const Point& point : points) {
    if (kept.empty() || kept.back().y != point.y) kept.push_back(point);
  }
  if (kept.back().x != points.back().x) kept.push_back(points.back());
  return kept;
}

class Picture {
 public:
  explicit Picture(const Trace& trace) : trace_(trace) {
    for (size_t i = 0; i < trace.columns().size(); ++i) AddColumn(i);
    for (Panel& panel : panels_) {
      if (panel.measures && !panel.curves.empty()) NameUnits(&panel);
    }
    AddPaths();
    if (!trace.rows().empty()) end_ms_ = ToMs(trace.rows().last().time_us);
    if (end_ms_ <= 0) end_ms_ = 1;
  }

  bool empty() const { return !HasPanel() && paths_.empty(); }

  std::string Script(const PlotOptions& options) {
    Layout();
    std::string text = "set encoding utf8\n";
    text += fmt::format("set terminal {} noenhanced size {},{} font {} background 'white'\n",
                        options.format == PictureFormat::kSvg ? "svg" : "pngcairo", width_, height_,
                        options.format == PictureFormat::kSvg ? "'sans-serif,13'" : "'sans,10'");
    text += "set style line 100 lc rgb '#D8D8D8' lt 1 lw 1\n";
    text += "set grid ls 100\nset border 3 lc rgb '#606060'\nset tics nomirror out\n";
    text += "set key at graph 1.02, graph 1 left top reverse Left samplen 1.6\n";
    WriteData(text);
    text += fmt::format("set multiplot title {} font ',16'\n", GnuplotString(options.title));
    WritePanels(text);
    for (size_t i = 0; i < paths_.size(); ++i) WritePath(text, i);
    text += "unset multiplot\n";
    return text;
  }

 private:
  // The label has the unit of all curves; if axes have several, the name of each curve has its own.
  static void NameUnits(Panel* panel) {
    std::vector<Curve>& curves = panel->curves;
    const std::string& unit = curves.front().unit;
    if (std::ranges::all_of(curves, [&](const Curve& curve) { return curve.unit == unit; })) {
      panel->label += fmt::format(" [{}]", unit);
      return;
    }
    for (Curve& curve : curves) curve.name += fmt::format(" [{}]", curve.unit);
  }

  // --- What there is to see --------------------------------------------------------------------

  bool HasPanel() const {
    return std::any_of(panels_.begin(), panels_.end(),
                       [](const Panel& panel) { return !panel.curves.empty(); });
  }

  Panel& PanelOf(const Quantity& quantity) {
    if (quantity.value != nullptr && !quantity.value->names.empty()) return NamedPanel(quantity);
    switch (quantity.unit()) {
      case Unit::kPulse:
        return panels_[quantity.value->name == "error" ? 3 : 0];
      case Unit::kPulsePerMs:
        return panels_[1];
      case Unit::kPulsePerMs2:
        return panels_[2];
      case Unit::kNone:
      case Unit::kVolt:
      case Unit::kKilohertz:
        break;
    }
    return panels_[4];
  }

  // The panel of a value that has names: 'drive state'. Before the signals.
  Panel& NamedPanel(const Quantity& quantity) {
    const std::string part = quantity.name.substr(0, quantity.name.find_first_of("0123456789"));
    const std::string label = fmt::format("{} {}", part, quantity.value->name);
    const auto found = std::ranges::find(panels_, label, &Panel::label);
    if (found != panels_.end()) return *found;
    return *panels_.insert(panels_.end() - 1, Panel{label, {}, false, quantity.value->names});
  }

  Panel& Signals() { return panels_.back(); }

  // A coordinate of a coordinate system is drawn as a path, not against time.
  static bool IsCoordinate(const Quantity& quantity) {
    return quantity.name.starts_with("crd") && quantity.unit() == Unit::kPulse;
  }

  static bool IsWord(const Quantity& quantity) {
    return quantity.kind == QuantityKind::kInputWord || quantity.kind == QuantityKind::kOutputWord;
  }

  // Values against time. There are rows only where something changed: a value is valid until the
  // cycle before it changes.
  std::vector<Point> Points(size_t column) const {
    std::vector<Point> points;
    std::optional<TraceRow> before;
    RowLog::Reader reader(trace_.rows(), {column});
    while (reader.Next()) {
      const TraceRow& row = reader.row();
      // Within a cycle only outputs are known.
      if (row.inside_cycle && trace_.form(column) == NumberForm::kReal) continue;
      if (before && row.time_us - before->time_us > trace_.cycle_us()) {
        points.push_back({ToMs(row.time_us - trace_.cycle_us()), before->values.front()});
      }
      points.push_back({ToMs(row.time_us), row.values.front()});
      before = row;
    }
    return points;
  }

  void AddColumn(size_t column) {
    const Quantity& quantity = trace_.columns()[column].quantity;
    if (trace_.rows().empty() || IsCoordinate(quantity)) return;
    std::vector<Point> points = Points(column);
    if (IsWord(quantity)) {
      AddBits(quantity.name, points);
    } else if (trace_.form(column) == NumberForm::kFlag) {
      AddSignal(quantity.name, points);
    } else if (RangeOf(points).size() > 0) {
      AddCurve(quantity, trace_.form(column), points);
    }
  }

  void AddCurve(const Quantity& quantity, NumberForm form, const std::vector<Point>& points) {
    Panel& panel = PanelOf(quantity);
    Curve curve;
    curve.name = quantity.name;
    curve.unit = quantity.UnitText(trace_.per_cycle());
    curve.steps = form != NumberForm::kReal;
    curve.points = curve.steps ? Changes(points) : Simplify(points);
    curve.color = quantity.value == nullptr ? panel.curves.size() : ColorOfPart(quantity.name);
    curve.dash = static_cast<int>(
        std::ranges::count(panel.curves, curve.color, [](const Curve& c) { return c.color; }));
    panel.curves.push_back(std::move(curve));
  }

  // All values of a part have the same colour.
  size_t ColorOfPart(const std::string& name) {
    const std::string part = name.substr(0, name.find('.'));
    const auto found = std::find(parts_.begin(), parts_.end(), part);
    if (found != parts_.end()) return static_cast<size_t>(found - parts_.begin());
    parts_.push_back(part);
    return parts_.size() - 1;
  }

  void AddBits(const std::string& word, const std::vector<Point>& points) {
    for (unsigned bit = 0; bit < 32; ++bit) {
      std::vector<Point> levels;
      levels.reserve(points.size());
      for (const Point& point : points) {
        levels.push_back({point.x, static_cast<double>(static_cast<int64_t>(point.y) >> bit & 1)});
      }
      AddSignal(fmt::format("{}[{}]", word, bit + 1), levels);
    }
  }

  void AddSignal(const std::string& name, const std::vector<Point>& points) {
    if (RangeOf(points).size() == 0) return;
    Signals().curves.push_back({name, Changes(points), true, Signals().curves.size()});
  }

  void AddPaths() {
    for (const auto& [x, y] : {std::pair{"x", "y"}, std::pair{"x", "z"}}) {
      for (int crd = 1; crd <= static_cast<int>(motion::kCrdCount); ++crd) {
        AddPath(fmt::format("crd{}.{}", crd, x), fmt::format("crd{}.{}", crd, y), y[0] == 'z');
      }
    }
  }

  std::optional<size_t> FindColumn(const std::string& name) const {
    for (size_t i = 0; i < trace_.columns().size(); ++i) {
      if (trace_.columns()[i].quantity.name == name) return i;
    }
    return std::nullopt;
  }

  void AddPath(const std::string& x, const std::string& y, bool only_if_y_changes) {
    const auto column_x = FindColumn(x);
    const auto column_y = FindColumn(y);
    if (!column_x || !column_y) return;
    Path path;
    path.label_x = fmt::format("{} [pulse]", x);
    path.label_y = fmt::format("{} [pulse]", y);
    const double first_y = trace_.rows().front().values[*column_y];
    Range height{first_y, first_y};
    RowLog::Reader reader(trace_.rows(), {*column_x, *column_y});
    while (reader.Next()) {
      const Point point{reader.row().values[0], reader.row().values[1]};
      height.Include(point.y);
      const std::vector<Point>& points = path.curve.points;
      if (points.empty() || points.back().x != point.x || points.back().y != point.y) {
        path.curve.points.push_back(point);
      }
    }
    if (path.curve.points.size() < 2 || (only_if_y_changes && height.size() == 0)) return;
    path.curve.points = SimplifyPath(path.curve.points);
    paths_.push_back(std::move(path));
  }

  // Removes points so close to the last one kept that the difference cannot be seen.
  static std::vector<Point> SimplifyPath(const std::vector<Point>& points) {
    Range x{points.front().x, points.front().x};
    Range y{points.front().y, points.front().y};
    for (const Point& point : points) {
      x.Include(point.x);
      y.Include(point.y);
    }
    const double near = std::max(x.size(), y.size()) / 800;
    std::vector<Point> kept;
    for (const Point& point : points) {
      const bool far = kept.empty() || std::fabs(point.x - kept.back().x) > near ||
                       std::fabs(point.y - kept.back().y) > near;
      if (far) kept.push_back(point);
    }
    kept.push_back(points.back());
    return kept;
  }

  // --- Where it stands -------------------------------------------------------------------------

  static int HeightOf(const Panel& panel) {
    return panel.signals ? kSignalHeight * static_cast<int>(panel.curves.size()) + kSignalHeight / 2
                         : kCurveHeight;
  }

  void Layout() {
    int stacked = 0;
    for (const Panel& panel : panels_) {
      if (!panel.curves.empty()) stacked += HeightOf(panel) + kGap;
    }
    time_width_ = stacked == 0 ? 0 : kTimeWidth;
    width_ = time_width_ + (paths_.empty() ? 0 : kPathWidth);
    const int paths = static_cast<int>(paths_.size()) * kPathHeightMin;
    height_ = kTitleHeight + kFooterHeight + std::max(stacked, paths);
  }

  double Across(int pixels) const { return static_cast<double>(pixels) / width_; }
  // Converts a distance from the top of the picture to a fraction from below.
  double Below(int pixels) const { return 1 - static_cast<double>(pixels) / height_; }

  static void WriteBox(std::string& text, const Box& box) {
    text += fmt::format(
        "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\n"
        "set tmargin at screen {}\n",
        Number(box.left), Number(box.right), Number(box.bottom), Number(box.top));
  }

  // --- The script ------------------------------------------------------------------------------

  static void WriteBlock(std::string& text, const std::string& name,
                         const std::vector<Point>& points, double offset, double scale) {
    text += fmt::format("${} << EOD\n", name);
    for (const Point& point : points) {
      text += fmt::format("{} {}\n", Number(point.x), Number(offset + scale * point.y));
    }
    text += "EOD\n";
  }

  void WriteData(std::string& text) const {
    for (size_t p = 0; p < panels_.size(); ++p) {
      const Panel& panel = panels_[p];
      for (size_t c = 0; c < panel.curves.size(); ++c) {
        // The first signal is at the top.
        const double row = static_cast<double>(panel.curves.size() - 1 - c);
        WriteBlock(text, fmt::format("p{}c{}", p, c), panel.curves[c].points,
                   panel.signals ? row : 0, panel.signals ? kSignalLevel : 1);
      }
    }
    for (size_t i = 0; i < paths_.size(); ++i) {
      WriteBlock(text, fmt::format("path{}", i), paths_[i].curve.points, 0, 1);
    }
  }

  void WritePanels(std::string& text) {
    size_t last = panels_.size();
    for (size_t p = 0; p < panels_.size(); ++p) {
      if (!panels_[p].curves.empty()) last = p;
    }
    if (last == panels_.size()) return;
    for (const TraceMark& mark : trace_.marks()) {
      if (mark.by_card) continue;
      text += fmt::format(
          "set arrow from {0}, graph 0 to {0}, graph 1 nohead back dt 3 lc rgb '#808080'\n",
          Number(ToMs(mark.time_us)));
    }
    text += fmt::format("set xrange [0:{}]\n", Number(end_ms_));
    int top = kTitleHeight;
    for (size_t p = 0; p <= last; ++p) {
      const Panel& panel = panels_[p];
      if (panel.curves.empty()) continue;
      const int height = HeightOf(panel);
      WriteBox(text, {Across(kLeftMargin), Across(time_width_ - kLegendWidth), Below(top + height),
                      Below(top)});
      text += p == last ? "set format x '%g'\nset xlabel 'time [ms]'\n"
                        : "set format x ''\nunset xlabel\n";
      if (panel.signals) {
        WriteSignalAxis(text, panel);
      } else if (!panel.names.empty()) {
        WriteNamedAxis(text, panel);
      } else {
        WriteValueAxis(text, panel);
      }
      WritePlot(text, p);
      top += height + kGap;
    }
    text += "unset arrow\n";
  }

  static void WriteSignalAxis(std::string& text, const Panel& panel) {
    std::vector<std::string> tics;
    for (size_t c = 0; c < panel.curves.size(); ++c) {
      const double row = static_cast<double>(panel.curves.size() - 1 - c);
      tics.push_back(fmt::format("{} {}", GnuplotString(panel.curves[c].name),
                                 Number(row + kSignalLevel / 2)));
    }
    text += fmt::format("set yrange [-0.25:{}]\nset ytics ({}) scale 0\nunset ylabel\nunset key\n",
                        panel.curves.size(), fmt::join(tics, ", "));
    text += "set grid noytics\n";
  }

  static Range RangeOfCurves(const Panel& panel) {
    Range range = RangeOf(panel.curves.front().points);
    for (const Curve& curve : panel.curves) {
      range.Include(RangeOf(curve.points).low);
      range.Include(RangeOf(curve.points).high);
    }
    return range;
  }

  static void WriteNamedAxis(std::string& text, const Panel& panel) {
    std::vector<std::string> tics;
    for (size_t value = 0; value < panel.names.size(); ++value) {
      if (panel.names[value].empty()) continue;
      tics.push_back(fmt::format("{} {}", GnuplotString(panel.names[value]), value));
    }
    const Range range = RangeOfCurves(panel);
    text += fmt::format("set yrange [{}:{}]\nset ytics ({}) scale 0\nunset ylabel\n",
                        Number(range.low - 0.5), Number(range.high + 0.5), fmt::join(tics, ", "));
  }

  static void WriteValueAxis(std::string& text, const Panel& panel) {
    const Range range = RangeOfCurves(panel);
    const double padding = range.size() * kPadding;
    text += fmt::format("set yrange [{}:{}]\nset ytics autofreq\n", Number(range.low - padding),
                        Number(range.high + padding));
    text += fmt::format("set ylabel {} offset character 0.5,0\n", GnuplotString(panel.label));
  }

  void WritePlot(std::string& text, size_t p) const {
    const Panel& panel = panels_[p];
    std::vector<std::string> plots;
    for (size_t c = 0; c < panel.curves.size(); ++c) {
      const Curve& curve = panel.curves[c];
      const std::string dash = curve.dash == 0 ? "" : fmt::format(" dt {}", curve.dash + 1);
      plots.push_back(fmt::format(
          "$p{}c{} with {} lw 2{} lc rgb '{}' title {}", p, c, curve.steps ? "steps" : "lines",
          dash, kColors[curve.color % kColors.size()], GnuplotString(curve.name)));
    }
    text += fmt::format("plot {}\n", fmt::join(plots, ", \\\n     "));
  }

  void WritePath(std::string& text, size_t index) const {
    const Path& path = paths_[index];
    const int share = (height_ - kTitleHeight - kFooterHeight) / static_cast<int>(paths_.size());
    const int top = kTitleHeight + share * static_cast<int>(index);
    const int box_width = kPathWidth - kPathMargin - kGap;
    const int box_height = share - kGap - (index + 1 < paths_.size() ? kFooterHeight : 0);
    WriteBox(text, {Across(time_width_ + kPathMargin), Across(width_ - kGap),
                    Below(top + box_height), Below(top)});
    // The same scale in both directions.
    Range x{path.curve.points.front().x, path.curve.points.front().x};
    for (const Point& point : path.curve.points) x.Include(point.x);
    const Range y = RangeOf(path.curve.points);
    const double scale =
        std::max(x.size() / box_width, y.size() / box_height) * (1 + 2 * kPadding) / 2;
    const double middle_x = x.low + x.size() / 2;
    const double middle_y = y.low + y.size() / 2;
    text +=
        fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n",
                    Number(middle_x - scale * box_width), Number(middle_x + scale * box_width),
                    Number(middle_y - scale * box_height), Number(middle_y + scale * box_height));
    text += "unset key\nset grid xtics ytics ls 100\nset ytics autofreq scale 1\n";
    text += fmt::format("set format x '%g'\nset xlabel {}\nset ylabel {} offset character 0.5,0\n",
                        GnuplotString(path.label_x), GnuplotString(path.label_y));
    text += fmt::format(
        "plot $path{0} with lines lw 2 lc rgb '{1}' notitle, \\\n     $path{0} every ::0::0 with "
        "points pt 7 ps 1.1 lc rgb '{1}' notitle\n",
        index, kColors[index % kColors.size()]);
  }

  const Trace& trace_;
  // In the order of the picture, without empty ones.
  std::vector<Panel> panels_ = {
      {.label = "position", .measures = true},
      {.label = "velocity", .measures = true},
      {.label = "acceleration", .measures = true},
      {.label = "following error", .measures = true},
      {.label = "variables"},
      {.signals = true},
  };
  std::vector<Path> paths_;
  std::vector<std::string> parts_;  // the parts that have a colour
  double end_ms_ = 1;
  int time_width_ = 0;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace

Result<std::string> PlotScript(const Trace& trace, const PlotOptions& options) {
  Picture picture(trace);
  if (picture.empty()) {
    return MakeError(1, "nothing to draw: no value changed during the run",
                     "没有可绘制的内容：运行期间没有任何量发生变化");
  }
  return picture.Script(options);
}

}  // namespace oncard::runtime
