// Moves the card, and tells the editor where it stands and whether the scenario is fulfilled.
// Tested by test/moving.test.ts.

import type { State, Stop, WalkResult } from "@oncard/engine";
import { ContinuedEvent, ExitedEvent, StoppedEvent, TerminatedEvent } from "@vscode/debugadapter";
import type { DebugProtocol } from "@vscode/debugprotocol";

import type { Editor } from "./editor.js";
import { hostThread } from "./host.js";
import { type Launched, renewCode } from "./launched.js";
import type { Movement } from "./movements.js";
import type { Stops } from "./stops.js";
import { describeStop, type Text, UserError } from "./texts.js";
import { judge, judgeHost, type Verdict } from "./verdict.js";
import { Warnings } from "./warnings.js";

const exceptionReasons = new Set([
  "fault",
  "refusal",
  "requirement",
  "race",
  "warning",
  "deviation",
]);

export class Mover {
  readonly #editor: Editor;
  readonly #stops: Stops;
  /** While the card moves: ends the movement. */
  #moving: AbortController | undefined;
  #last: Stop | undefined;
  #verdict: Verdict | undefined;
  #warnings = new Warnings();

  constructor(editor: Editor, stops: Stops) {
    this.#editor = editor;
    this.#stops = stops;
  }

  /** Moves the card. The response is sent as soon as it is certain that the engine agrees. */
  move(launched: Launched, response: DebugProtocol.Response, movement: Movement): void {
    if (this.#moving) {
      this.#editor.fail(response, new UserError({ en: "the card is running", zh: "卡正在运行" }));
      return;
    }
    const moving = new AbortController();
    this.#moving = moving;
    let answered = false;
    const before = launched.state;
    const onSlice = ({ state }: WalkResult) => {
      launched.state = state;
      launched.variables.reset();
      if (!answered) this.#editor.send(response);
      answered = true;
      if (this.#moving === moving) this.#warnings.show(launched, this.#editor);
    };
    movement
      .walk(launched.engine, { signal: moving.signal, onSlice })
      .then(async (result) => {
        onSlice(result);
        await renewCode(launched, before);
        // Nobody waits for a movement that was abandoned.
        if (this.#moving !== moving) return undefined;
        this.#moving = undefined;
        return this.#arrive(launched, result, movement);
      })
      .catch((error: unknown) => {
        if (this.#moving === moving) this.#moving = undefined;
        // An engine that has ended says so itself.
        if (!answered) this.#editor.fail(response, error);
      });
  }

  /** The editor does not expect the card to move: it is told when that takes long. */
  moveFromConsole(launched: Launched, response: DebugProtocol.Response, movement: Movement): void {
    let told = false;
    this.move(launched, response, {
      ...movement,
      walk: (engine, { onSlice, ...options }) =>
        movement.walk(engine, {
          ...options,
          onSlice: (result) => {
            onSlice?.(result);
            if (!told) this.#editor.tell(new ContinuedEvent(1, true));
            told = true;
          },
        }),
    });
  }

  /** Ends a movement where the card is. */
  pause(): void {
    this.#moving?.abort();
  }

  /** Forgets the card: another one takes its place. */
  abandon(): void {
    this.#moving?.abort();
    this.#moving = undefined;
    this.#last = undefined;
    this.#verdict = undefined;
    this.#warnings = new Warnings();
  }

  /** The card stands before its first step. */
  enter({ state }: Launched): void {
    this.#tellStopped(state, "entry", state.next_thread ?? hostOf(state));
  }

  /** The user goes on where the run is over. */
  async finish(launched: Launched): Promise<void> {
    const { exitCode } = this.#verdict ?? (await this.#showVerdict(launched));
    this.#editor.tell(new ExitedEvent(exitCode));
    this.#editor.tell(new TerminatedEvent());
  }

  /** Why the card stands. */
  exception({ state }: Launched): DebugProtocol.ExceptionInfoResponse["body"] {
    const text = this.#last && describeStop(this.#last, state);
    return {
      exceptionId: this.#last?.reason ?? "",
      description: text ? this.#editor.say(text) : "",
      breakMode: "always",
    };
  }

  // --- Arriving ----------------------------------------------------------------------------------

  async #arrive(
    launched: Launched,
    { stop, state }: WalkResult,
    movement: Movement,
  ): Promise<void> {
    this.#last = stop;
    this.#verdict = undefined;
    if (stop.reason === "end") {
      if (launched.config.noDebug) {
        await this.finish(launched);
        return;
      }
      await this.#showVerdict(launched);
    }
    const text = describeStop(stop, state);
    // A warning has just been shown.
    if (text && stop.reason !== "warning") {
      this.#editor.print(`${this.#editor.say(text)}\n`, "console");
    }
    const byHost = exceptionReasons.has(stop.reason);
    const thread =
      stop.thread ??
      (byHost ? hostOf(state) : undefined) ??
      movement.thread ??
      state.next_thread ??
      hostOf(state);
    const wish = this.#stops.reached(stop);
    await this.#stops.passed(wish, launched.engine);
    const reason = wish?.reason ?? reasonOf(stop, movement);
    this.#tellStopped(state, reason, thread, text, wish?.id);
  }

  #tellStopped(
    { threads }: State,
    reason: string,
    thread = threads[0]?.thread,
    text?: Text,
    breakpoint?: number,
  ): void {
    const event = new StoppedEvent(reason, thread === undefined ? undefined : thread + 1);
    const body: DebugProtocol.StoppedEvent["body"] = event.body;
    body.allThreadsStopped = true;
    if (text) {
      body.description = this.#editor.say(text);
      body.text = this.#editor.say(text);
    }
    if (breakpoint !== undefined) body.hitBreakpointIds = [breakpoint];
    this.#editor.tell(event);
  }

  async #showVerdict({ engine, config, state }: Launched): Promise<Verdict> {
    this.#verdict = state.host ? judgeHost(this.#last) : await judge(engine, config);
    const { exitCode, text } = this.#verdict;
    this.#editor.print(`${this.#editor.say(text)}\n`, exitCode === 0 ? "stdout" : "stderr");
    return this.#verdict;
  }
}

/** What the protocol calls a stop. */
function reasonOf({ reason }: Stop, movement: Movement): string {
  if (exceptionReasons.has(reason)) return "exception";
  if (reason === "line") return "breakpoint";
  if (reason === "change") return "data breakpoint";
  if (reason === "start") return "entry";
  if (reason === "budget") return "pause";
  return movement.reason;
}

/** The host where there is one: it acts where no thread does. */
function hostOf({ host }: State): number | undefined {
  return host && hostThread;
}
