// The commands of the debug console; everything else typed there is evaluated.

import type { State } from "@oncard/engine";

import { back, forward, type Movement, turnOf } from "./movements.js";
import { toStatement } from "./statements.js";

export type Command =
  | { do: "help" | "count" }
  | { do: "cycle" | "rest" }
  | { do: "thread"; thread: number }
  | { do: "statement"; number: number }
  | { do: "back"; name: string }
  | { do: "record"; file: string };

export const commandHelp = {
  en: `cycle             go to the end of this cycle
rest              go on until no thread runs and no axis moves
thread N          thread N executes its next statement, whatever the schedule says
statement         how many statements of the run have been executed
statement N       go to after statement N of the run, forward or back
back change NAME  go back to before the last change of a value
record FILE       write the run up to now as a schedule file, beside the program
NAME, CONDITION   show a value, or whether a condition holds
`,
  zh: `cycle             运行到本周期结束
rest              运行到没有线程运行、没有轴运动为止
thread N          让线程 N 执行下一条语句，不论调度如何
statement         本次运行已执行多少条语句
statement N       前进或后退到本次运行的第 N 条语句之后
back change NAME  后退到某个量上一次改变之前
record FILE       将到目前为止的运行写成调度文件，保存在程序所在目录
名称、条件         显示值，或条件是否成立
`,
};

/** Nothing if the text is no command. */
export function readCommand(text: string): Command | undefined {
  const line = text.trim();
  if (line === "cycle" || line === "rest" || line === "help") return { do: line };
  if (line === "statement") return { do: "count" };
  const number = /^statement\s+(\d+)$/.exec(line)?.[1];
  if (number !== undefined) return { do: "statement", number: Number(number) };
  const thread = /^thread\s+(\d+)$/.exec(line)?.[1];
  if (thread !== undefined) return { do: "thread", thread: Number(thread) };
  const name = /^back\s+change\s+(\S.*)$/.exec(line)?.[1];
  if (name !== undefined) return { do: "back", name };
  const file = /^record\s+(\S.*)$/.exec(line)?.[1];
  if (file !== undefined) return { do: "record", file };
  return undefined;
}

/** How a command moves the card. */
export function movementOf(
  command: Exclude<Command, { do: "help" | "count" | "record" }>,
): Movement {
  switch (command.do) {
    case "cycle":
    case "rest":
      return forward({ goal: command.do });
    case "thread":
      return turnOf(command.thread);
    case "statement":
      return toStatement(command.number);
    case "back":
      return back({ goal: "change", name: command.name });
  }
}

/** The commands that begin with what has been typed; behind those that end in a blank more follows. */
export function commandsIn(typed: string, { threads }: State): string[] {
  const ready = threads.filter((thread) => thread.ready).map(({ thread }) => `thread ${thread}`);
  const all = ["cycle", "rest", ...ready, "statement ", "back change ", "record ", "help"];
  return all.filter((command) => command.startsWith(typed.trimStart()));
}

/** True if what has been typed is the beginning of a command that no name follows. */
export function isCommandOnly(typed: string): boolean {
  return /^\s*(?:(?:thread|statement|back)\s+$|record\s)/.test(typed);
}
