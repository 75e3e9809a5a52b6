// Writes requests to the module with everything, one in each line, and beside them the answers of
// this computer's build: sessions of hosts that drive cards, and of one that only opens a card for
// each family. tests/web/record_equality_test.mjs gives the requests to the module.
//   web_record_requests REQUESTS ANSWERS
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "gtcalls/card_type.h"
#include "gtcalls/families.h"
#include "tests/runtime/recording_host.h"
#include "tests/web/request_files.h"

namespace oncard::web {
namespace {

using Json = nlohmann::ordered_json;

constexpr int64_t kMotionUs = 50'000;

/// A program on a GTS card.
std::string ProgramRecord() {
  runtime::RecordingHost host;
  host.Download("move",
                "int f()\n{\n  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n"
                "  GT_Update(1);\n}\n");
  host.Start();
  host.Wait(kMotionUs);
  host.Close();
  return host.text();
}

std::string PointToPointRecord() {
  runtime::RecordingHost host("GE-400-PV");
  host.Call("GT_AxisOn", {1});
  host.Call("GT_SetKp", {1, 20});
  host.Call("GT_PrflS", {1});
  host.Call("GT_SetPos", {1, 500});
  host.Call("GT_SetVel", {1, 20});
  host.Call("GT_SetMAcc", {1, 2});
  host.Call("GT_SetJerk", {1, 0.5});
  host.Call("GT_Update", {1});
  host.Wait(kMotionUs);
  host.Close();
  return host.text();
}

std::string PathRecord() {
  runtime::RecordingHost host("GE-300-SG");
  host.Call("GT_AxisOn", {1});
  host.Call("GT_AxisOn", {2});
  host.Call("GT_StrtList", {});
  host.Call("GT_MvXY", {0, 0, 20, 0.5});
  host.Call("GT_LnXY", {300, 100});
  host.Call("GT_ArcXY", {300, 300, 90});
  host.Call("GT_EndList", {});
  host.Call("GT_StrtMtn", {});
  host.Wait(kMotionUs);
  host.Close();
  return host.text();
}

std::string IdleRecord(const gtcalls::CardType& card) {
  runtime::RecordingHost host(card.name);
  host.Wait(kMotionUs);
  host.Close();
  return host.text();
}

std::vector<Json> Requests() {
  std::vector<std::pair<std::string, std::string>> records = {{"program.calls", ProgramRecord()},
                                                              {"point.calls", PointToPointRecord()},
                                                              {"path.calls", PathRecord()}};
  for (const gtcalls::Family* family : gtcalls::Families()) {
    records.emplace_back(std::string(family->name) + ".calls", IdleRecord(family->default_card));
  }
  std::vector<Json> requests;
  const auto ask = [&](const std::string& id, const std::string& request, Json arguments) {
    requests.push_back({{"id", id}, {"request", request}, {"arguments", std::move(arguments)}});
  };
  for (const auto& [name, text] : records) {
    ask(name, "load", {{"main", name}, {"files", {{name, text}}}});
    ask(name, "forward", {{"goal", "call"}});
    ask(name, "forward", {{"goal", "time"}, {"ms", 20}});
    ask(name, "card", Json::object());
    ask(name, "forward", {{"goal", "stop"}});
    ask(name, "card", Json::object());
    ask(name, "trace",
        {{"names", {"axis1.prfPos", "axis2.prfPos"}},
         {"from_ms", 0},
         {"to_ms", 40},
         {"points", 9}});
    ask(name, "back", {{"goal", "call"}});
    ask(name, "set_input", {{"type", "gpi"}, {"index", 1}, {"level", 0}});
    ask(name, "forward", {{"goal", "stop"}});
  }
  return requests;
}

}  // namespace
}  // namespace oncard::web

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  return oncard::web::WriteRequests(oncard::web::Requests(), argv[1], argv[2]);
}
