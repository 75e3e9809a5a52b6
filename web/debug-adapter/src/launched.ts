// What exists from a successful launch on, and how a launch succeeds.

import type { Compiled, Engine, State, Thread } from "@oncard/engine";
import { TerminatedEvent } from "@vscode/debugadapter";

import { Code } from "./code.js";
import type { Editor } from "./editor.js";
import { threadOfHost, withRecord } from "./host.js";
import type { LaunchConfig } from "./launch.js";
import { startEngine } from "./start.js";
import type { Stops } from "./stops.js";
import { UserError } from "./texts.js";
import { Variables } from "./variables.js";

export interface Launched {
  readonly config: LaunchConfig;
  readonly engine: Engine;
  /** Of the program that the card has. */
  code: Code;
  readonly variables: Variables;
  /** The card as it stands, or as it was last heard of while it moves. */
  state: State;
}

/** Starts an engine with the program, or with what a host does, and installs the stops. */
export async function launch(
  config: LaunchConfig,
  stops: Stops,
  editor: Editor,
): Promise<Launched> {
  const { host } = config;
  return host
    ? withRecord(config, host, editor, (record) => open(config, record, stops, editor))
    : open(config, config.program, stops, editor);
}

async function open(
  config: LaunchConfig,
  program: string,
  stops: Stops,
  editor: Editor,
): Promise<Launched> {
  const engine = await startEngine(config);
  try {
    await engine.hello(editor.language);
    const { structured, stopAtFunction, card, silent } = config;
    const options = card === undefined ? { silent } : { silent, card };
    const loaded = await engine.load({ main: program, structured }, options);
    for (const each of loaded.diagnostics) editor.showDiagnostic(each);
    if (!loaded.compiled) throw notCompiled(loaded, program);
    if (loaded.choice) showChoice(loaded.choice, editor);
    const code = new Code(loaded.files, await engine.listing());
    const known = loaded.state.host ?? code.beginning(stopAtFunction ?? "");
    if (stopAtFunction !== undefined && !known) {
      throw noFunction(stopAtFunction, code.names());
    }
    stops.once(config.noDebug ? undefined : stopAtFunction);
    if (config.noDebug) stops.filter([]);
    await stops.install(engine);
    report(engine, editor);
    return { config, engine, code, variables: new Variables(engine), state: loaded.state };
  } catch (error) {
    engine.close();
    throw error;
  }
}

/** Of a scenario that leaves something open one case is debugged. */
function showChoice(choice: string, editor: Editor): void {
  editor.print(`${editor.say({ en: `choice: ${choice}`, zh: `选择：${choice}` })}\n`, "console");
}

/** What the engine says without having been asked. */
function report(engine: Engine, editor: Editor): void {
  engine.onLog = ({ thread, text }) => {
    editor.print(`[${thread}] ${text}\n`, "console");
  };
  engine.onEnded = (why) => {
    editor.print(`${why.message}\n`, "stderr");
    editor.tell(new TerminatedEvent());
  };
}

/** The card's thread with the editor's id of it or of its frame: 1 is added to its number. */
export function threadOf({ state }: Launched, id: number): Thread {
  const host = threadOfHost(state);
  const threads = host ? [...state.threads, host] : state.threads;
  const found = threads.find(({ thread }) => thread === id - 1);
  if (found) return found;
  throw new UserError({ en: `there is no thread ${id - 1}`, zh: `没有线程 ${id - 1}` });
}

/** To be called when the card has moved: a host may have downloaded another program. */
export async function renewCode(launched: Launched, before: State): Promise<void> {
  if (launched.state.host?.program === before.host?.program) return;
  launched.code = launched.code.with(await launched.engine.listing());
}

export function notLaunched(): UserError {
  return new UserError({ en: "nothing has been launched", zh: "尚未启动程序" });
}

function noFunction(name: string, names: readonly string[]): UserError {
  const all = names.join(", ");
  return new UserError({
    en: `'stopAtFunction' of the launch configuration: the program has no function '${name}' with statements; it has ${all}`,
    zh: `启动配置的“stopAtFunction”：程序中没有含语句的函数“${name}”；只有 ${all}`,
  });
}

function notCompiled({ diagnostics }: Compiled, program: string): UserError {
  const first = diagnostics.find(({ severity }) => severity === "error");
  const why = first ? `${first.file}:${first.line}:${first.column}: ${first.message}` : "";
  return new UserError({
    en: `${program} was not compiled: ${why}`,
    zh: `${program} 未能编译：${why}`,
  });
}
