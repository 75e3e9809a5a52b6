// A session of the engine: one method for each request of the protocol. Requests are answered in
// their order, whoever makes them.
// Tested by test/engine.test.ts and test/walk.test.ts.

import type { ExploreAnswer, ExploreRequest } from "./explore.js";
import type {
  Answer,
  BackWalk,
  Card,
  Channel,
  Compiled,
  Completion,
  Description,
  Edit,
  Evaluation,
  FileRange,
  Fixes,
  Fold,
  ForwardWalk,
  Hello,
  Hint,
  Language,
  ListedFunction,
  Loaded,
  LineWrites,
  LogEvent,
  Lowered,
  OutlineEntry,
  Project,
  Reference,
  Requests,
  RunAnswer,
  Signature,
  SourcePlace,
  SourceProject,
  State,
  StopWishes,
  ThreadSpan,
  Turn,
  TwoColumns,
  Variable,
  WalkResult,
  Word,
} from "./protocol.js";
import type { Transport } from "./transport.js";

/** The engine has refused a request; the message is its own. Nothing has changed. */
export class RefusedError extends Error {}

/** What a walk does between its slices. */
export interface WalkOptions {
  /** Ends the walk after the present slice. */
  signal?: AbortSignal;
  /** Called after each slice that did not arrive. */
  onSlice?: (result: WalkResult) => void;
  /** Steps in a slice; other requests are answered between two of them. */
  slice?: number;
}

const stepsOfSlice = 50_000;

/** Of the protocol that is spoken here. */
const protocolVersion: Hello["protocol"] = 1;

/** How a project is loaded. */
export type LoadOptions = Omit<Requests["load"]["arguments"], keyof Project>;

interface AnyRequest extends Requests {
  explore: ExploreRequest;
}
/** JSON leaves out what is undefined. */
type Arguments<Request extends keyof AnyRequest> = OrUndefined<AnyRequest[Request]["arguments"]>;
type OrUndefined<Type> = { [Key in keyof Type]: Type[Key] | undefined };
type Result<Request extends keyof AnyRequest> = AnyRequest[Request]["result"];

interface Waiting {
  /** Takes the answer and its text. */
  resolve: (answer: Answer & { text: string }) => void;
  reject: (why: Error) => void;
}

export class Engine {
  /** Called for each line of a log point. */
  onLog: (event: LogEvent) => void = () => undefined;
  /**
   * Reads a file that a project lacks, for an engine without a file system. The request is then
   * repeated with it. Nothing if there is none.
   */
  supply: ((path: string) => Promise<string | undefined>) | undefined;
  /** Called when the engine ends by itself. */
  onEnded: (why: Error) => void = () => undefined;

  readonly #transport: Transport;
  readonly #waiting = new Map<Answer["id"], Waiting>();
  #requests = 0;
  #ended: Error | undefined;

  constructor(transport: Transport) {
    this.#transport = transport;
    transport.connect({
      line: (text) => {
        this.#receive(text);
      },
      ended: (why) => {
        this.#end(why);
        this.onEnded(why);
      },
    });
  }

  /** Ends the engine; requests without an answer fail. */
  close(): void {
    this.#end(new Error("the session was closed"));
    this.#transport.close();
  }

  // --- Requests ----------------------------------------------------------------------------------

  hello(language?: Language): Promise<Hello> {
    return this.#request("hello", { protocol: protocolVersion, language });
  }
  check(project: Project): Promise<Compiled> {
    return this.#requestWithFiles("check", project);
  }
  /** Runs a whole project beside the session. */
  run(project: Project, show: string[] = []): Promise<RunAnswer> {
    return this.#requestWithFiles("run", { ...project, show });
  }
  /** Searches all interleavings; only oncard-full.wasm answers this. */
  explore(project: Project, language?: Language): Promise<ExploreAnswer> {
    return this.#requestWithFiles("explore", { ...project, language });
  }
  load(project: Project, options: LoadOptions = {}): Promise<Loaded> {
    return this.#requestWithFiles("load", { ...project, ...options });
  }
  state(): Promise<State> {
    return this.#request("state", {});
  }
  /** One slice of a walk; `walkForward` goes on until it arrives. */
  forward(walk: ForwardWalk, budget?: number): Promise<WalkResult> {
    return this.#request("forward", { ...walk, budget });
  }
  back(walk: BackWalk, budget?: number): Promise<WalkResult> {
    return this.#request("back", { ...walk, budget });
  }
  stepThread(thread: number): Promise<WalkResult> {
    return this.#request("step_thread", { thread });
  }
  /** To a moment that has been reached, or to the end of a cycle. */
  goTo(place: { moment: number } | { ms: number }): Promise<State> {
    return this.#request("go_to", place);
  }
  setStops(wishes: StopWishes): Promise<{ lines: number[] }> {
    return this.#request("set_stops", { ...wishes });
  }
  /** The global variables, or those of a data page. */
  variables(page?: number): Promise<Variable[]> {
    return this.#request("variables", { page });
  }
  /** The slots of a data page: integers of 64 bits. */
  async slots(page: number): Promise<BigInt64Array> {
    const { text } = await this.#exchange("slots", { page });
    // Numbers of JavaScript would lose their last bits.
    const list = /"result":\[([^\]]*)\]/.exec(text)?.[1] ?? "";
    return BigInt64Array.from(list.split(",").map(BigInt));
  }
  card(): Promise<Card> {
    return this.#request("card", {});
  }
  /** With a thread, names are meant as in its function: its locals first. */
  evaluate(text: string, thread?: number): Promise<Evaluation> {
    return this.#request("evaluate", { text, thread });
  }
  write(name: string, value: number): Promise<State> {
    return this.#request("write", { name, value });
  }
  setInput(type: string, index: number, level: number): Promise<State> {
    return this.#request("set_input", { type, index, level });
  }
  setVoltage(channel: number, volts: number): Promise<State> {
    return this.#request("set_voltage", { channel, volts });
  }
  /** In pulses, or in the unit of its axis; on one side unlimited without a position. */
  moveSwitch(number: number, from?: number, to?: number): Promise<State> {
    return this.#request("move_switch", { switch: number, from, to });
  }
  trace(names: string[], fromMs: number, toMs: number, points: number): Promise<Channel[]> {
    return this.#request("trace", { names, from_ms: fromMs, to_ms: toMs, points });
  }
  turns(from: number, to: number, most?: number): Promise<Turn[]> {
    return this.#request("turns", { from, to, most });
  }
  spans(from?: number, to?: number, most?: number): Promise<ThreadSpan[]> {
    return this.#request("spans", { from, to, most });
  }
  /** What lines wrote when they were executed last, among so many statements before the present. */
  written(statements?: number): Promise<LineWrites[]> {
    return this.#request("written", { statements });
  }
  listing(): Promise<ListedFunction[]> {
    return this.#request("listing", {});
  }
  /** The texts of a schedule file and of its scenario, with the changes, for a file at `path`. */
  record(path?: string): Promise<{ schedule: string; scenario: string }> {
    return this.#request("record", { path });
  }

  // --- Sources -----------------------------------------------------------------------------------

  /** What the name or number at a place is; null if there is neither. */
  describe(place: SourcePlace): Promise<Description | null> {
    return this.#requestWithFiles("describe", place);
  }
  /** The call around a place; null if there is none. */
  signature(place: SourcePlace): Promise<Signature | null> {
    return this.#requestWithFiles("signature", place);
  }
  complete(place: SourcePlace): Promise<Completion> {
    return this.#requestWithFiles("complete", place);
  }
  outline(file: SourceProject): Promise<OutlineEntry[]> {
    return this.#requestWithFiles("outline", file);
  }
  definition(place: SourcePlace): Promise<FileRange[]> {
    return this.#requestWithFiles("definition", place);
  }
  references(place: SourcePlace, declaration = true): Promise<Reference[]> {
    return this.#requestWithFiles("references", { ...place, declaration });
  }
  rename(place: SourcePlace, name: string): Promise<Edit[]> {
    return this.#requestWithFiles("rename", { ...place, name });
  }
  tokens(file: SourceProject): Promise<Word[]> {
    return this.#requestWithFiles("tokens", file);
  }
  folds(file: SourceProject): Promise<Fold[]> {
    return this.#requestWithFiles("folds", file);
  }
  hints(file: SourceProject): Promise<Hint[]> {
    return this.#requestWithFiles("hints", file);
  }
  fixes(project: Project): Promise<Fixes> {
    return this.#requestWithFiles("fixes", project);
  }
  lower(project: Project): Promise<Lowered> {
    return this.#requestWithFiles("lower", project);
  }
  /** Structured C beside what it becomes. */
  twoColumns(project: Project): Promise<TwoColumns> {
    return this.#requestWithFiles("two_columns", project);
  }

  // --- Walks -------------------------------------------------------------------------------------

  /** Goes forward until it arrives or stops. A cancelled walk has the stop `budget`. */
  async walkForward(walk: ForwardWalk, options: WalkOptions = {}): Promise<WalkResult> {
    if (walk.goal !== "time") return inSlices((budget) => this.forward(walk, budget), options);
    const goal = (await this.state()).time_ms + walk.ms;
    let left = walk.ms;
    return inSlices(async (budget) => {
      const result = await this.forward({ goal: "time", ms: left }, budget);
      left = Math.max(0, goal - result.state.time_ms);
      return result;
    }, options);
  }

  /** Goes back until it arrives or stops. A cancelled walk has the stop `budget`. */
  walkBack(walk: BackWalk, options: WalkOptions = {}): Promise<WalkResult> {
    return inSlices((budget) => this.back(walk, budget), options);
  }

  // --- Lines -------------------------------------------------------------------------------------

  async #request<Request extends keyof Requests>(
    request: Request,
    args: Arguments<Request>,
  ): Promise<Result<Request>> {
    // The engine keeps to the protocol: its version was checked by `hello`.
    return (await this.#exchange(request, args)).result as Result<Request>;
  }

  /** Repeats a request until nothing that it lacks can be supplied. */
  async #requestWithFiles<Request extends keyof AnyRequest>(
    request: Request,
    args: Arguments<Request> & Pick<Project, "files">,
  ): Promise<Result<Request>> {
    const files = { ...args.files };
    for (;;) {
      const answer = await this.#ask(request, { ...args, files });
      if (!(await this.#addTo(files, answer.missing ?? []))) {
        if (answer.ok) return answer.result as Result<Request>;
        throw new RefusedError(answer.error);
      }
    }
  }

  /** True if one of the missing files could be supplied. */
  async #addTo(files: Record<string, string>, missing: readonly string[]): Promise<boolean> {
    let added = false;
    for (const path of missing) {
      const text = path in files ? undefined : await this.supply?.(path);
      if (text === undefined) continue;
      files[path] = text;
      added = true;
    }
    return added;
  }

  async #exchange(request: string, args: object): Promise<{ result: unknown; text: string }> {
    const answer = await this.#ask(request, args);
    if (!answer.ok) throw new RefusedError(answer.error);
    return answer;
  }

  #ask(request: string, args: object): Promise<Answer & { text: string }> {
    if (this.#ended) return Promise.reject(this.#ended);
    const id = ++this.#requests;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.#transport.send(JSON.stringify({ id, request, arguments: args }));
    });
  }

  #receive(text: string): void {
    let message: Answer | LogEvent;
    try {
      message = JSON.parse(text) as Answer | LogEvent;
    } catch {
      const why = new Error(`this is not an answer of the session protocol: ${text.slice(0, 200)}`);
      this.#end(why);
      this.#transport.close();
      this.onEnded(why);
      return;
    }
    if ("event" in message) {
      this.onLog(message);
      return;
    }
    const waiting = this.#waiting.get(message.id);
    if (!waiting) return;
    this.#waiting.delete(message.id);
    waiting.resolve({ ...message, text });
  }

  #end(why: Error): void {
    this.#ended ??= why;
    for (const { reject } of this.#waiting.values()) reject(why);
    this.#waiting.clear();
  }
}

/** Repeats a walk until its budget was enough. */
async function inSlices(
  walk: (budget: number) => Promise<WalkResult>,
  { signal, onSlice, slice = stepsOfSlice }: WalkOptions,
): Promise<WalkResult> {
  for (;;) {
    const result = await walk(slice);
    if (result.stop.reason !== "budget") return result;
    onSlice?.(result);
    // Whatever else has happened comes first, also where an engine answers at once.
    await new Promise((resume) => setTimeout(resume));
    if (signal?.aborted) return result;
  }
}
