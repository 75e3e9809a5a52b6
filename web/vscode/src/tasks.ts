// Tasks: what the command does, or the module where there is none.
// Tested by test/tasks.test.ts.

import {
  CustomExecution,
  type Disposable,
  EventEmitter,
  ProcessExecution,
  type Pseudoterminal,
  Task,
  TaskScope,
  tasks,
  window,
  workspace,
} from "vscode";

import { kindOf } from "./documents";
import type { Engines } from "./engines";
import { checked, explored, type Outcome, ran } from "./runs";
import { language, say } from "./texts";

export const taskCommands = ["build", "check", "run", "explore", "test"] as const;
type Command = (typeof taskCommands)[number];

interface OncardTask {
  type: string;
  command: Command;
  file: string;
}

export const matchers = ["$oncard", "$oncard-error-zh", "$oncard-warning-zh", "$oncard-scenario"];

export function registerTasks(engines: Engines): Disposable {
  return tasks.registerTaskProvider("oncard", {
    provideTasks: async () => {
      const document = window.activeTextEditor?.document;
      const kind = document && (await kindOf(document));
      if (kind === undefined) return [];
      const possible = taskCommands.filter((command) =>
        kind === "program" ? command !== "test" : command !== "build" && command !== "check",
      );
      const file = document?.uri.fsPath ?? "";
      return possible.map((command) => taskOf(engines, { type: "oncard", command, file }));
    },
    resolveTask: ({ definition }) => taskOf(engines, definition as OncardTask),
  });
}

/** A task for a file; its definition stays as it is written. */
export function taskOf(engines: Engines, definition: OncardTask): Task {
  const { command, file } = definition;
  const native = engines.command();
  const execution =
    native === undefined
      ? new CustomExecution(() =>
          Promise.resolve(terminal((line) => work(engines, command, pathOf(file), line))),
        )
      : new ProcessExecution(native, [`--lang=${language()}`, command, file]);
  const name = `${command} ${workspace.asRelativePath(file)}`;
  return new Task(definition, TaskScope.Workspace, name, "oncard", execution, matchers);
}

/** A custom task's file is not resolved by the editor. */
function pathOf(file: string): string {
  const folder = workspace.workspaceFolders?.[0]?.uri.fsPath ?? "";
  const open = window.activeTextEditor?.document.uri.fsPath ?? "";
  return file.replaceAll("${workspaceFolder}", folder).replaceAll("${file}", open);
}

/** Does with the module what the command would do; the exit code. */
async function work(
  engines: Engines,
  command: Command,
  file: string,
  line: (text: string) => void,
): Promise<number> {
  if (command === "build") {
    line(
      say({
        en: "building .bin and .ini files needs the oncard command: set oncard.path",
        zh: "生成 .bin 和 .ini 文件需要 oncard 命令：请设置 oncard.path",
      }),
    );
    return 2;
  }
  const engine = await engines.openModule();
  try {
    const { passed, lines } = await outcome(command, engine, file);
    lines.forEach(line);
    return passed ? 0 : 1;
  } finally {
    engine.close();
  }
}

function outcome(
  command: Exclude<Command, "build">,
  engine: Parameters<typeof ran>[0],
  file: string,
): Promise<Outcome> {
  if (command === "check") return checked(engine, file);
  if (command === "explore") return explored(engine, file, language());
  return ran(engine, file);
}

/** Shows the lines of some work. */
function terminal(work: (line: (text: string) => void) => Promise<number>): Pseudoterminal {
  const written = new EventEmitter<string>();
  const closed = new EventEmitter<number>();
  const line = (text: string) => {
    written.fire(`${text}\r\n`);
  };
  return {
    onDidWrite: written.event,
    onDidClose: closed.event,
    open: () => {
      work(line).then(
        (code) => {
          closed.fire(code);
        },
        (error: unknown) => {
          line(error instanceof Error ? error.message : String(error));
          closed.fire(4);
        },
      );
    },
    close: () => undefined,
  };
}
