#include "tools/explore_options.h"

#include <fmt/core.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/path_bytes.h"
#include "explore/engines/sampler.h"
#include "runtime/scenario/file/scenario_keys.h"
#include "runtime/scenario/file/search_names.h"
#include "tools/commands.h"
#include "tools/search_watch.h"

namespace oncard::tools {

void AddExploreOptions(CLI::App& command, const Invocation& invocation,
                       ExploreArguments& arguments) {
  command
      .add_option("file", arguments.paths,
                  invocation.Say({"scenario (.toml), a source with //@ comments, the record of a "
                                  "host (.calls), or an interrupted search (.search)",
                                  "场景文件（.toml）、带 //@ 注释的源程序、主机记录（.calls），"
                                  "或中断的搜索（.search）"}))
      ->required()
      ->type_name("FILE");
  command
      .add_option(
          "--engine", arguments.engine,
          invocation.Say(
              {"auto (default), dpor or stateful search all schedules; bounded those with few "
               "preemptions; random, pct and pos try some",
               "auto（默认）、dpor 或 stateful 搜索所有调度；bounded "
               "搜索抢占较少的调度；random、pct "
               "和 pos 只尝试一部分"}))
      ->type_name("NAME")
      ->check(CLI::IsMember(std::vector<std::string>(runtime::kEngineNames.begin(),
                                                     runtime::kEngineNames.end()))
                  .description(""));
  command
      .add_option("--preemptions", arguments.preemptions,
                  invocation.Say({"maximum number of preemptions, for bounded (default 2)",
                                  "bounded 引擎的最大抢占次数（默认 2）"}))
      ->type_name("N")
      ->check(CLI::Range(0, runtime::kPreemptionsMax).description(""));
  AddStructuredOption(command, invocation, arguments.structured);
  command.add_flag(
      "--merge-private", arguments.merge_private,
      invocation.Say(
          {"combine statements that access no global with the one before them, or say why that is "
           "not possible (without it, they are combined where it is)",
           "将不涉及全局变量的语句并入前一条语句，不能合并时说明原因（无此选项时，能合并则合并"
           "）"}));
  command.add_flag("--no-merge-private", arguments.no_merge_private,
                   invocation.Say({"count every state between two statements: more states",
                                   "统计任意两条语句之间的每个状态：状态更多"}));
  command.add_flag(
      "--no-dead-locals", arguments.no_dead_locals,
      invocation.Say(
          {"tell states apart by the value of a local even where it cannot be read any more",
           "局部变量的值即使不会再被读取，也用来区分状态"}));
  command.add_flag(
      "--no-symmetry", arguments.no_symmetry,
      invocation.Say({"tell states apart that differ only in which of several equal threads "
                      "is where",
                      "相同的线程仅互换位置时，也算不同的状态"}));
  command.add_flag(
      "--no-islands", arguments.no_islands,
      invocation.Say({"with a card: search the states of all threads together, even if "
                      "some share nothing with the others",
                      "带控制卡时：即使有线程互不相关，也一起搜索所有线程的状态"}));
  command.add_flag(
      "--no-reductions", arguments.no_reductions,
      invocation.Say({"with a card: search every order of the statements of a cycle, even if "
                      "nobody notices which came first",
                      "带控制卡时：搜索每个周期内语句的所有次序，即使次序对任何线程都没有影响"}));
  command.add_flag(
      "--full", arguments.full,
      invocation.Say({"show every statement of a failing run and every pass of its loops",
                      "列出出错运行的每条语句，循环逐次列出"}));
  command.add_flag("--races", arguments.races,
                   invocation.Say({"data races and axes with two owners are failures",
                                   "将数据竞争和同时有两个归属线程的轴视为失败"}));
  command.add_flag("--benign", arguments.benign,
                   invocation.Say({"the same, except races that change no final value",
                                   "同上，但不改变任何最终值的竞争除外"}));
  command
      .add_option("--runs", arguments.runs,
                  invocation.Say({"number of random schedules (default 10000)",
                                  "尝试的随机调度数（默认 10000）"}))
      ->type_name("N")
      ->check(CLI::Range(int64_t{1}, runtime::kSearchCountMax).description(""));
  command
      .add_option(
          "--seed", arguments.seed,
          invocation.Say({"seed of the random schedules (default 1)", "随机调度的种子（默认 1）"}))
      ->type_name("N");
  command
      .add_option("--depth", arguments.depth,
                  invocation.Say({"number of orderings that a fault needs, for pct (default 3)",
                                  "pct 引擎所假定的错误深度（默认 3）"}))
      ->type_name("N")
      ->check(CLI::Range(1, explore::kPctDepthMax).description(""));
  command
      .add_option("--save", arguments.save,
                  invocation.Say({"write a failing schedule for 'oncard replay'",
                                  "写出失败的调度，供“oncard replay”使用"}))
      ->type_name("FILE");
  command
      .add_option(
          "--regression", arguments.regression,
          invocation.Say({"write a scenario for 'oncard test' that checks a failing schedule "
                          "again, and the schedule beside it",
                          "写出供“oncard test”再次检查失败调度的场景，调度文件在其旁边"}))
      ->type_name("FILE.toml")
      ->check([&invocation](const std::string& path) {
        if (path.ends_with(".toml")) return std::string();
        return invocation.Say({"the file name must end in .toml", "文件名应以 .toml 结尾"});
      });
  command
      .add_option(
          "--report", arguments.report,
          invocation.Say({"write the result as a page (.html), or a failure as trace events "
                          "(.json)",
                          "将结果写成网页（.html），或将失败写成跟踪事件（.json）"}))
      ->type_name("FILE")
      ->check([&invocation](const std::string& path) {
        if (path.ends_with(".html") || path.ends_with(".json")) return std::string();
        return invocation.Say(
            {"the file name must end in .html or .json", "文件名应以 .html 或 .json 结尾"});
      });
  command
      .add_option("--max-executions", arguments.execution_limit,
                  invocation.Say({"end the search after N executions", "执行次数上限"}))
      ->type_name("N")
      ->check(CLI::Range(int64_t{1}, runtime::kSearchCountMax).description(""));
  command
      .add_option("--max-states", arguments.state_limit,
                  invocation.Say({"end the search after N states", "状态数上限"}))
      ->type_name("N")
      ->check(CLI::Range(uint32_t{1}, runtime::kSearchStatesMax).description(""));
  command
      .add_option("--time", arguments.seconds,
                  invocation.Say({"end the search after this time and report what is known",
                                  "搜索超过该秒数后结束，并给出已知结果"}))
      ->type_name("SECONDS")
      ->check(CLI::Range(0.001, 1e9).description(""));
  command
      .add_option(
          "--memory", arguments.memory_mib,
          invocation.Say({"end it when it occupies so much; without it, half of what is free",
                          "占用内存达到该值时结束；默认为可用内存的一半"}))
      ->type_name("MIB")
      ->check(CLI::Range(int64_t{1}, kMemoryMibMax).description(""));
  command.add_flag("--all", arguments.all,
                   invocation.Say({"continue after a failure, so that all are counted",
                                   "出错后继续搜索，以统计全部错误"}));
  command
      .add_option("--search", arguments.search,
                  invocation.Say({"save the search in this file; continue it if the file exists",
                                  "将搜索保存到该文件；文件已存在时继续该搜索"}))
      ->type_name("FILE");
  command
      .add_option(
          "--shard", arguments.shard,
          invocation.Say({"search only the I-th of N parts, for --merge; saved in a search file",
                          "只搜索 N 部分中的第 I 部分，供 --merge 合并；结果存入搜索文件"}))
      ->type_name("I/N");
  command.add_flag("--merge", arguments.merge,
                   invocation.Say({"merge the search files of the parts", "合并各部分的搜索文件"}));
  command.add_flag("--progress", arguments.progress,
                   invocation.Say({"show the progress every second (default on a terminal)",
                                   "每秒显示搜索进度（终端上默认开启）"}));
}

std::string SameSearch(const ExploreArguments& arguments) {
  std::string line = "oncard explore";
  const auto flag = [&](std::string_view name, bool given) {
    if (given) line += fmt::format(" {}", name);
  };
  const auto option = [&](std::string_view name, const auto& value) {
    line += fmt::format(" {}={}", name, value);
  };
  flag("--merge", arguments.merge);
  for (const std::string& path : arguments.paths) {
    const std::string name = FileNameOf(PathOf(path).filename());
    line += name.find_first_of(" '\"$&;()<>|*?") == std::string::npos
                ? ' ' + name
                : fmt::format(" \"{}\"", name);
  }
  if (!arguments.engine.empty()) option("--engine", arguments.engine);
  if (arguments.preemptions) option("--preemptions", *arguments.preemptions);
  flag("--structured", arguments.structured);
  flag("--merge-private", arguments.merge_private);
  flag("--no-merge-private", arguments.no_merge_private);
  flag("--no-islands", arguments.no_islands);
  flag("--races", arguments.races);
  flag("--benign", arguments.benign);
  if (arguments.runs != 0) option("--runs", arguments.runs);
  if (arguments.seed) option("--seed", *arguments.seed);
  if (arguments.depth) option("--depth", *arguments.depth);
  if (arguments.execution_limit != 0) option("--max-executions", arguments.execution_limit);
  if (arguments.state_limit != 0) option("--max-states", arguments.state_limit);
  flag("--all", arguments.all);
  if (!arguments.shard.empty()) option("--shard", arguments.shard);
  return line;
}

}  // namespace oncard::tools
