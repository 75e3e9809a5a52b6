// Breakpoints as the editor sets and shows them.
// Tested by test/breakpoints.test.ts.

import type { LineStop } from "@oncard/engine";
import { Event } from "@vscode/debugadapter";
import type { DebugProtocol } from "@vscode/debugprotocol";

import type { Code } from "./code.js";
import type { Editor } from "./editor.js";
import { evaluateAt } from "./evaluation.js";
import type { Launched } from "./launched.js";
import { readHits, type Stops, type Wish } from "./stops.js";

/** What the editor has asked for, in a program. */
type Asked = (code: Code) => Omit<Wish, "id">[];

export class Breakpoints {
  readonly #editor: Editor;
  readonly #stops: Stops;
  /** By group. */
  readonly #asked = new Map<string, Asked>();

  constructor(editor: Editor, stops: Stops) {
    this.#editor = editor;
    this.#stops = stops;
  }

  /** Replaces those of a source. */
  async setLines(
    launched: Launched,
    { source, breakpoints }: DebugProtocol.SetBreakpointsArguments,
  ): Promise<DebugProtocol.Breakpoint[]> {
    const group = `source ${source.path ?? source.name ?? ""}`;
    const wishes = await this.#set(launched, group, (code) =>
      (breakpoints ?? []).map((each) => this.#lineWish(code.fileOf(source), each)),
    );
    return wishes.map((wish) => shown(wish, source));
  }

  async setFunctions(
    launched: Launched,
    { breakpoints }: DebugProtocol.SetFunctionBreakpointsArguments,
  ): Promise<DebugProtocol.Breakpoint[]> {
    const wishes = await this.#set(launched, "functions", (code) =>
      breakpoints.map(({ name, condition }) => {
        const beginning = code.beginning(name);
        const refused = { en: `there is no function '${name}'`, zh: `没有函数“${name}”` };
        return beginning
          ? { at: { line: { ...beginning, condition: condition ?? "" } } }
          : { refused: this.#editor.say(refused) };
      }),
    );
    return wishes.map((wish) => shown(wish));
  }

  async setInstructions(
    launched: Launched,
    { breakpoints }: DebugProtocol.SetInstructionBreakpointsArguments,
  ): Promise<DebugProtocol.Breakpoint[]> {
    const wishes = await this.#set(launched, "instructions", (code) =>
      breakpoints.map((each) => this.#instructionWish(code, each)),
    );
    return wishes.map((wish) => shown(wish));
  }

  async setData(
    launched: Launched,
    { breakpoints }: DebugProtocol.SetDataBreakpointsArguments,
  ): Promise<DebugProtocol.Breakpoint[]> {
    const wishes = await this.#set(launched, "changes", () =>
      breakpoints.map(({ dataId }) => ({ at: { change: dataId } })),
    );
    return wishes.map((wish) => shown(wish));
  }

  /** Whether changes of something can be waited for. */
  async dataInfo(
    launched: Launched,
    { variablesReference, name, frameId }: DebugProtocol.DataBreakpointInfoArguments,
  ): Promise<DebugProtocol.DataBreakpointInfoResponse["body"]> {
    const path = variablesReference
      ? await launched.variables.path(variablesReference, name)
      : (await evaluateAt(launched, name, frameId)).path;
    if (path !== undefined) {
      return { dataId: path, description: path, accessTypes: ["write"], canPersist: true };
    }
    const description = this.#editor.say({ en: "this has no name", zh: "此项没有名称" });
    return { dataId: null, description };
  }

  async setExceptions(launched: Launched, filters: readonly string[]): Promise<void> {
    this.#stops.filter(filters);
    await this.#install(launched);
  }

  /** Sets all of them in another program, and tells the editor what has become of them. */
  async renew(launched: Launched): Promise<void> {
    const wishes = [...this.#asked].flatMap(([group, asked]) =>
      this.#stops.renew(group, asked(launched.code)),
    );
    await this.#install(launched);
    for (const wish of wishes) {
      const event: DebugProtocol.BreakpointEvent["body"] = {
        reason: "changed",
        breakpoint: shown(wish),
      };
      this.#editor.tell(new Event("breakpoint", event));
    }
  }

  /** Replaces those of a group. */
  async #set(launched: Launched, group: string, asked: Asked): Promise<Wish[]> {
    this.#asked.set(group, asked);
    const wishes = this.#stops.replace(group, asked(launched.code));
    await this.#install(launched);
    return wishes;
  }

  /** A run without debugging stops nowhere. */
  async #install({ config, engine }: Launched): Promise<void> {
    if (!config.noDebug) await this.#stops.install(engine);
  }

  #lineWish(
    file: string | undefined,
    { line, logMessage, ...options }: DebugProtocol.SourceBreakpoint,
  ): Omit<Wish, "id"> {
    if (file === undefined) {
      const refused = {
        en: "no statement of the program is in this file",
        zh: "程序中没有语句在此文件中",
      };
      return { refused: this.#editor.say(refused) };
    }
    return this.#wish({ file, line, log: logMessage ?? "" }, options);
  }

  #instructionWish(
    code: Code,
    { instructionReference, offset = 0, ...options }: DebugProtocol.InstructionBreakpoint,
  ): Omit<Wish, "id"> {
    const statement = code.statementAt(Number(instructionReference) + offset);
    if (!statement) {
      const refused = {
        en: "no statement of the program is at this address",
        zh: "程序中没有语句在此地址",
      };
      return { refused: this.#editor.say(refused) };
    }
    const { function: name, position } = statement;
    const wish = this.#wish({ function: name, position }, options);
    return { ...wish, reason: "instruction breakpoint" };
  }

  /** A stop at a place with what the editor says of all of them. */
  #wish(
    at: LineStop,
    { condition = "", hitCondition = "" }: { condition?: string; hitCondition?: string },
  ): Omit<Wish, "id"> {
    const hits = hitCondition === "" ? 0 : readHits(hitCondition);
    if (hits !== undefined) return { at: { line: { ...at, condition, hits } } };
    const refused = {
      en: `the hit condition '${hitCondition}' must be a number: stop from this arrival on`,
      zh: `命中条件“${hitCondition}”应为数字：从该次到达起停止`,
    };
    return { refused: this.#editor.say(refused) };
  }
}

function shown(
  { id, line, refused }: Wish,
  source?: DebugProtocol.Source,
): DebugProtocol.Breakpoint {
  if (refused !== undefined) return { id, verified: false, message: refused };
  return {
    id,
    verified: true,
    ...(line === undefined ? {} : { line }),
    ...(line !== undefined && source ? { source } : {}),
  };
}
