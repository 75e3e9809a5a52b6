// What the editor shows in its tree of variables, and which of it can be changed.

import type {
  Card,
  CardPart,
  CardWord,
  Engine,
  HostState,
  State,
  Thread,
  Value,
  Variable,
} from "@oncard/engine";
import { Handles, Scope } from "@vscode/debugadapter";
import type { DebugProtocol } from "@vscode/debugprotocol";

import { UserError } from "./texts.js";

type Group = "axes" | "io" | "card";

/** What can be opened in the tree. */
type Node =
  | { kind: "locals"; page: number }
  | { kind: "globals" }
  | { kind: "array"; path: string }
  | { kind: "group"; group: Group }
  | { kind: "part"; part: string; number: number }
  | { kind: "word"; name: string };

const inputOutputParts = new Set(["adc", "dac", "hsio"]);

export class Variables {
  readonly #engine: Engine;
  readonly #nodes = new Handles<Node>();
  /** The card as it was asked for last; empty after the state has changed. */
  #card: Promise<Card> | undefined;

  constructor(engine: Engine) {
    this.#engine = engine;
  }

  /** Forgets everything: the card has moved on. */
  reset(): void {
    this.#nodes.reset();
    this.forgetValues();
  }

  /** Forgets values only: something was changed. */
  forgetValues(): void {
    this.#card = undefined;
  }

  scopes(thread: Thread): DebugProtocol.Scope[] {
    const locals: DebugProtocol.Scope = new Scope(
      "Locals",
      this.#nodes.create({ kind: "locals", page: thread.page }),
    );
    locals.presentationHint = "locals";
    const group = (name: string, group: Group) =>
      new Scope(name, this.#nodes.create({ kind: "group", group }), true);
    return [
      // A host has none.
      ...(thread.page < 0 ? [] : [locals]),
      new Scope("Globals", this.#nodes.create({ kind: "globals" })),
      group("Axes", "axes"),
      group("Inputs and outputs", "io"),
      group("Card", "card"),
    ];
  }

  /** A value for the console, hovers and watches; arrays can be opened. */
  shown(path: string, value: Value): { value: string; variablesReference: number } {
    if (!Array.isArray(value)) return { value: String(value), variablesReference: 0 };
    return {
      value: `[${value.join(", ")}]`,
      variablesReference: this.#nodes.create({ kind: "array", path }),
    };
  }

  async children(reference: number, state: State): Promise<DebugProtocol.Variable[]> {
    const node = this.#node(reference);
    switch (node.kind) {
      case "locals":
        return (await this.#engine.variables(node.page)).map((each) =>
          this.#variable(each, node.page),
        );
      case "globals":
        return (await this.#engine.variables()).map((each) => this.#variable(each));
      case "array":
        return this.#elements(node.path);
      case "group":
        return this.#group(node.group, await this.#cardNow(), state);
      case "part": {
        const part = (await this.#cardNow()).parts.find(
          (each) => each.part === node.part && each.number === node.number,
        );
        return part ? part.values.map(partValue) : [];
      }
      case "word": {
        const word = (await this.#cardNow()).words.find(({ name }) => name === node.name);
        return word ? pins(word) : [];
      }
    }
  }

  /** Changes a child of what was opened; gives its new value. */
  async set(reference: number, name: string, value: string): Promise<string> {
    const node = this.#node(reference);
    const number = numberOf(value);
    switch (node.kind) {
      case "locals":
      case "globals":
      case "array": {
        const path = await this.path(reference, name);
        await this.#engine.write(path ?? name, number);
        this.forgetValues();
        const now = await this.#engine.evaluate(path ?? name);
        return "value" in now ? String(now.value) : String(number);
      }
      case "word":
        await this.#engine.setInput(node.name, Number(name), number);
        this.forgetValues();
        return String(number);
      case "part":
        if (node.part !== "adc" || name !== "volts") break;
        await this.#engine.setVoltage(node.number, number);
        this.forgetValues();
        return String(number);
      case "group":
        break;
    }
    throw new UserError({
      en: `'${name}' is what the card makes of its inputs: variables, input pins and the voltages of adc can be changed`,
      zh: `“${name}”由卡自行得出，不能更改：可以更改变量、输入引脚和 adc 的电压`,
    });
  }

  /** The engine's name for a child of what was opened, if it has one. */
  async path(reference: number, name: string): Promise<string | undefined> {
    const node = this.#node(reference);
    switch (node.kind) {
      case "locals":
      case "globals": {
        const page = node.kind === "locals" ? node.page : undefined;
        return (await this.#engine.variables(page)).find((each) => each.name === name)?.path;
      }
      case "array":
        return `${node.path}${name}`;
      case "part": {
        const card = await this.#cardNow();
        const part = card.parts.find(
          (each) => each.part === node.part && each.number === node.number,
        );
        return part?.values.find((each) => shownName(each.name) === name)?.path;
      }
      case "group": {
        const { words } = await this.#cardNow();
        return node.group === "io" ? words.find((word) => word.name === name)?.name : undefined;
      }
      case "word":
        return undefined;
    }
  }

  #node(reference: number): Node {
    const node = this.#nodes.get(reference) as Node | undefined;
    if (node) return node;
    throw new UserError({
      en: "the card has moved on: look again",
      zh: "卡已继续运行：请重新查看",
    });
  }

  #cardNow(): Promise<Card> {
    this.#card ??= this.#engine.card();
    return this.#card;
  }

  #variable({ name, path, type, slot, value }: Variable, page?: number): DebugProtocol.Variable {
    const variable: DebugProtocol.Variable = {
      name,
      type,
      evaluateName: path,
      ...this.shown(path, value),
    };
    if (Array.isArray(value)) variable.indexedVariables = value.length;
    if (page !== undefined) variable.memoryReference = `page${page}:${slot}`;
    return variable;
  }

  async #elements(path: string): Promise<DebugProtocol.Variable[]> {
    const now = await this.#engine.evaluate(path);
    const values = "value" in now && Array.isArray(now.value) ? now.value : [];
    return values.map((value, i) => ({
      name: `[${i}]`,
      value: String(value),
      evaluateName: `${path}[${i}]`,
      variablesReference: 0,
    }));
  }

  #group(group: Group, card: Card, state: State): DebugProtocol.Variable[] {
    const parts = (wanted: (part: string) => boolean) =>
      card.parts.filter(({ part }) => wanted(part)).map((part) => this.#part(part));
    switch (group) {
      case "axes":
        return parts((part) => part === "axis");
      case "io":
        return [
          ...card.words.map((word) => this.#word(word)),
          ...parts((part) => inputOutputParts.has(part)),
        ];
      case "card": {
        const { threads, warnings, host, ...facts } = state;
        const counts = { threads: threads.length, warnings: warnings.length };
        return [
          ...Object.entries({ ...facts, ...namesOfHost(host), ...counts }).map(([name, value]) => ({
            name,
            value: String(value),
            variablesReference: 0,
          })),
          ...parts((part) => part !== "axis" && !inputOutputParts.has(part)),
        ];
      }
    }
  }

  #part({ part, number, values }: CardPart): DebugProtocol.Variable {
    const first = values[0];
    return {
      name: `${part}${number}`,
      value: first ? `${shownName(first.name)} ${partValue(first).value}` : "",
      variablesReference: this.#nodes.create({ kind: "part", part, number }),
    };
  }

  #word(word: CardWord): DebugProtocol.Variable {
    return {
      name: word.name,
      value: `0x${word.value.toString(16)}`,
      type: word.kind,
      evaluateName: word.name,
      variablesReference:
        word.kind === "input" ? this.#nodes.create({ kind: "word", name: word.name }) : 0,
    };
  }
}

function partValue({
  name,
  path,
  value,
  unit,
}: CardPart["values"][number]): DebugProtocol.Variable {
  return {
    name: shownName(name),
    value: unit === undefined ? String(value) : `${value} ${unit}`,
    evaluateName: path,
    variablesReference: 0,
  };
}

/** A part such as a converter has one value without a name. */
function shownName(name: string): string {
  return name === "" ? "value" : name;
}

/** The bits of an input word, from pin 1. */
function pins(word: CardWord): DebugProtocol.Variable[] {
  return Array.from({ length: word.pins }, (_, bit) => ({
    name: String(bit + 1),
    value: String((word.value >> bit) & 1),
    variablesReference: 0,
  }));
}

/** @throws UserError if a text is no number */
export function numberOf(text: string): number {
  const number = text.trim() === "" ? NaN : Number(text);
  if (Number.isFinite(number)) return number;
  throw new UserError({ en: `'${text}' is no number`, zh: `“${text}”不是数字` });
}

/** What is known of a host, among the facts of the card. */
function namesOfHost(host: HostState | undefined): Record<string, string | number> {
  if (!host) return {};
  const { calls, made, last = "", next = "" } = host;
  return { host_calls: calls, host_calls_made: made, last_call: last, next_call: next };
}
