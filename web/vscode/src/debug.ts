// Debugging: the adapter in a process of its own, launches without a configuration, and the commands
// that only this debugger has.
// Tested by test/debug.test.ts.

import {
  commands,
  debug,
  type DebugAdapterDescriptor,
  DebugAdapterExecutable,
  type DebugConfiguration,
  type DebugSession,
  type Disposable,
  window,
} from "vscode";

import type { Engines } from "./engines";
import { say } from "./texts";

/** A node of the editor's call stack, as its menus give it. */
interface CallStackItem {
  threadId?: number | string;
}

export function registerDebug(engines: Engines): Disposable[] {
  return [
    debug.registerDebugAdapterDescriptorFactory("oncard", {
      createDebugAdapterDescriptor: () => adapterOf(engines),
    }),
    debug.registerDebugConfigurationProvider("oncard", {
      resolveDebugConfiguration: (_, config) => completed(config),
    }),
    commands.registerCommand("oncard.runThreadNext", runThreadNext),
    commands.registerCommand("oncard.saveSchedule", saveSchedule),
  ];
}

/** The editor runs what is called `node` with its own Node. */
function adapterOf(engines: Engines): DebugAdapterDescriptor {
  const command = engines.command();
  const env: Record<string, string> =
    command === undefined ? { ONCARD_MODULE: engines.module } : { ONCARD: command };
  return new DebugAdapterExecutable("node", [engines.adapter], { env });
}

/** Without launch.json, the open file is debugged. */
function completed(config: DebugConfiguration): DebugConfiguration | undefined {
  const named: unknown = config["program"] ?? config["host"];
  if (config.type !== "" && named !== undefined) return config;
  const file = window.activeTextEditor?.document.uri;
  if (file?.scheme !== "file") {
    const text = {
      en: "open a program, a scenario or a recording first",
      zh: "请先打开程序、场景或记录",
    };
    void window.showErrorMessage(say(text));
    return undefined;
  }
  const added = { type: "oncard", request: "launch", name: "oncard", stopOnEntry: true };
  return { ...added, ...withoutEmpty(config), program: file.fsPath };
}

function withoutEmpty(config: DebugConfiguration): Partial<DebugConfiguration> {
  return Object.fromEntries(Object.entries(config).filter(([, value]) => value !== ""));
}

/** Stands before the first statement of a function, or after one of the run; otherwise before all. */
export function startDebugging(
  program: string,
  where: { stopAtFunction?: string; stopAtStatement?: number } = {},
): Thenable<boolean> {
  const place = Object.keys(where).length > 0 ? where : { stopOnEntry: true };
  const config = { type: "oncard", request: "launch", name: "oncard", program, ...place };
  return debug.startDebugging(undefined, config);
}

/** The thread of the menu, or one that the user chooses, executes its next statement. */
async function runThreadNext(item?: CallStackItem): Promise<void> {
  const session = debug.activeDebugSession;
  if (session?.type !== "oncard") return;
  const { threads } = (await session.customRequest("threads")) as {
    threads: { id: number; name: string }[];
  };
  const picked =
    threads.find(({ id }) => id === Number(item?.threadId)) ??
    (await window.showQuickPick(threads.map(({ id, name }) => ({ id, label: name }))));
  if (picked) await execute(`thread ${picked.id - 1}`);
}

/** Writes the run up to now as a recording beside the program. */
async function saveSchedule(): Promise<void> {
  if (debug.activeDebugSession?.type !== "oncard") return;
  const name = await window.showInputBox({
    value: "run.schedule",
    prompt: say({
      en: "name of the recording; it is kept beside the program",
      zh: "记录的文件名；保存在程序所在目录",
    }),
  });
  if (!name) return;
  const path = await execute(`record ${name}`);
  if (path === undefined) return;
  void window.showInformationMessage(say({ en: `saved ${path}`, zh: `已保存 ${path}` }));
}

/** A command of the debugger's console; its answer, or nothing if it failed, which the user is told. */
export async function execute(
  expression: string,
  session = debug.activeDebugSession,
): Promise<string | undefined> {
  try {
    return session && (await inConsole(session, expression));
  } catch (error) {
    void window.showErrorMessage(error instanceof Error ? error.message : String(error));
    return undefined;
  }
}

/** The answer to a command of the debugger's console. */
export async function inConsole(session: DebugSession, expression: string): Promise<string> {
  const args = { expression, context: "repl" };
  return ((await session.customRequest("evaluate", args)) as { result: string }).result;
}
