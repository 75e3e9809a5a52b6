// The session of the page: one program on the card, driven by the reader. It owns two slices: what
// the session does, and how the card is at the present moment, which changes in `#show` alone.

import type {
  Card,
  Compiled,
  ListedFunction,
  Engine,
  Loaded,
  LoadOptions,
  Project,
  State,
  Stop,
  Variable,
  WalkResult,
} from "@oncard/engine";
import { RefusedError } from "@oncard/engine";
import { batch } from "@preact/signals";

import { settings } from "../store/settings.js";
import { slice } from "../store/slice.js";
import { fetchForRecords, type Purpose, startEngine } from "./engines.js";

/** What the status line says. */
export type Notice =
  | { kind: "starting" }
  | { kind: "fetching" }
  | { kind: "ready" }
  | { kind: "running" }
  | { kind: "stopped"; stop: Stop }
  | { kind: "not-compiled" }
  | { kind: "not-loaded"; message: string }
  | { kind: "refused"; message: string }
  | { kind: "engine-ended"; message: string }
  | { kind: "no-engine"; message: string }
  | { kind: "no-records"; message: string };

/** How many steps a step of the reader may take until a thread executes a statement. */
const stepsToStatement = 20_000;
/** So many moments are looked at for the last statement first, then four times as many. */
const firstLook = 500;
/** Steps in one request of a run; other requests are answered after them. */
const stepsOfRun = 40_000;

interface Session {
  notice: Notice;
  running: boolean;
  /** What is on the card, or should be there soon. */
  project: Project | undefined;
  listing: ListedFunction[];
  /** What was chosen of what the scenario leaves open; empty if it leaves nothing open. */
  choice: string;
  /** Lines of the program before which a run stops, in their order. */
  breakpoints: readonly number[];
  /** Grows when values of the past may have changed: with each load, choice and change. */
  history: number;
  /** The history at the last load; nothing has been changed by hand while it is the present one. */
  loaded: number;
}

/** The card at the present moment. Without a program there is no state and no card. */
interface Present {
  state: State | undefined;
  card: Card | undefined;
  globals: Variable[];
  /** Of each bound data page. */
  locals: ReadonlyMap<number, Variable[]>;
}

const nothing: Present = { state: undefined, card: undefined, globals: [], locals: new Map() };

const [session, changeSession] = slice<Session>({
  notice: { kind: "starting" },
  running: false,
  project: undefined,
  listing: [],
  choice: "",
  breakpoints: [],
  history: 0,
  loaded: 0,
});
const [present, changePresent] = slice<Present>(nothing);
export { present, session };

interface Loading {
  /** What the reader works on. */
  project: Project;
  /** The project with a recording of it. */
  loaded?: Project;
  /** What stays on the card if the project does not compile. */
  before?: Project | undefined;
  /** Which part of a record. */
  options?: LoadOptions | undefined;
  /** What comes before any walk, even one that was asked for meanwhile. */
  prepare?: (engine: Engine) => Promise<void>;
  /** The same, once the card is shown before its first step. */
  begin?: (engine: Engine) => Promise<void>;
}

type Success = Extract<Loaded, { compiled: true }>;

class Bench {
  #engine: Promise<Engine> | undefined;
  #purpose: Purpose = "programs";
  #work: Promise<unknown> = Promise.resolve();
  /** What is changed beside the work; work that is asked for later waits for it. */
  #changes: Promise<unknown> = Promise.resolve();
  /** The run that goes on until it is paused; whatever is done next ends it. */
  #run: AbortController | undefined;
  /** The present walk; a step is short, and ended by a pause alone. */
  #walk: AbortController | undefined;
  #head = 0;

  // --- Engine ------------------------------------------------------------------------------------

  engine(): Promise<Engine> {
    this.#engine ??= this.#start();
    return this.#engine;
  }

  async #start(): Promise<Engine> {
    try {
      const engine = await startEngine(this.#purpose);
      engine.onEnded = ({ message }) => {
        this.#engine = undefined;
        this.pause();
        this.#clear({ kind: "engine-ended", message });
      };
      await engine.hello(settings.language.value);
      return engine;
    } catch (error) {
      this.#engine = undefined;
      const message = error instanceof Error ? error.message : String(error);
      if (session.notice.peek().kind !== "engine-ended") {
        this.#clear({ kind: "no-engine", message });
      }
      throw error;
    }
  }

  /**
   * From now on the engine reads records. True if it is another one than before, with nothing on
   * the card.
   * @throws its module cannot be fetched; the engine is the one before
   */
  async #learnRecords(): Promise<boolean> {
    if (this.#purpose === "records") return false;
    const { value: before } = session.notice;
    changeSession({ notice: { kind: "fetching" } });
    const isOther = await fetchForRecords();
    changeSession({ notice: before });
    this.#purpose = "records";
    if (!isOther) return false;
    const old = this.#engine;
    this.#engine = undefined;
    (await old)?.close();
    return true;
  }

  #clear(notice: Notice): void {
    batch(() => {
      changePresent(nothing);
      changeSession({ notice, listing: [], choice: "", running: false });
    });
  }

  /** The language of the engine's texts has changed. */
  async speak(): Promise<void> {
    await this.#then(async (engine) => {
      await engine.hello(settings.language.value);
      if (present.state.peek()) await this.#show(await engine.state());
    });
  }

  /** What the compiler says of a project. */
  async check(project: Project): Promise<Compiled> {
    return (await this.engine()).check(project);
  }

  // --- Loading -----------------------------------------------------------------------------------

  /**
   * Loads another project with the breakpoints; the card is then before its first step. True if it
   * compiles; otherwise nothing is on the card.
   */
  async load(project: Project): Promise<boolean> {
    const prepare = (engine: Engine) => this.#setStops(engine);
    return (await this.#load({ project, prepare })) !== undefined;
  }

  /** The same after an edit; if that does not compile, what was there before stays on the card. */
  async loadEdited(project: Project): Promise<boolean> {
    const before = present.state.peek() && session.project.peek();
    const prepare = (engine: Engine) => this.#setStops(engine);
    return (await this.#load({ project, before, prepare })) !== undefined;
  }

  /**
   * Loads the record of a host; the card is then before its first call. Nothing if that is not
   * possible, and then what was there before stays on the card.
   */
  async loadRecord(project: Project, options: LoadOptions): Promise<Success | undefined> {
    this.pause();
    const before = present.state.peek() && session.project.peek();
    let isOther: boolean;
    try {
      isOther = await this.#learnRecords();
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      changeSession({ notice: { kind: "no-records", message } });
      return undefined;
    }
    const success = await this.#load({ project, before: isOther ? undefined : before, options });
    if (!success && isOther && before) {
      const { value: notice } = session.notice;
      await this.load(before);
      changeSession({ notice });
    }
    return success;
  }

  /** What the engine answers; nothing if the project is not on the card. */
  async #load(loading: Loading): Promise<Success | undefined> {
    const { project, loaded = project, before, options, prepare, begin } = loading;
    changeSession({ project });
    const refuse = (notice: Notice) => {
      if (before) changeSession({ notice, project: before });
      else this.#clear(notice);
    };
    let success: Success | undefined;
    await this.#then(async (engine) => {
      try {
        const answer = await engine.load(loaded, options);
        if (!answer.compiled) {
          refuse({ kind: "not-compiled" });
          return;
        }
        this.#head = 0;
        changeSession({ listing: await engine.listing(), choice: answer.choice ?? "" });
        await prepare?.(engine);
        this.#changeHistory();
        changeSession({ loaded: session.history.peek() });
        await this.#show(answer.state, { kind: "ready" });
        await begin?.(engine);
        success = answer;
      } catch (error) {
        if (!(error instanceof RefusedError)) throw error;
        refuse({ kind: "not-loaded", message: error.message });
      }
    });
    return success;
  }

  /**
   * Loads a recording of this project and goes to its end, past all breakpoints; whatever is asked for
   * meanwhile comes after that.
   * @returns the history of the session with the recording; undefined if that is not on the card
   */
  async loadRecording(project: Project, schedule: string): Promise<number | undefined> {
    const main = project.main.replace(/\.[^.]*$/, ".schedule");
    const files = { ...project.files, [main]: schedule };
    let history: number | undefined;
    const begin = async (engine: Engine) => {
      await this.#arrived(await engine.walkForward({ goal: "stop" }));
      history = session.history.peek();
      await this.#setStops(engine);
    };
    await this.#load({ project, loaded: { ...project, main, files }, begin });
    return history;
  }

  /** Replaces the breakpoints of what is loaded: each goes to the next line with a statement. */
  stopAt(wished: readonly number[]): Promise<void> {
    this.wishStops(wished);
    return this.#then((engine) => this.#setStops(engine), true);
  }

  /** Replaces the breakpoints of what will be loaded next. */
  wishStops(breakpoints: readonly number[]): void {
    changeSession({ breakpoints });
  }

  async #setStops(engine: Engine): Promise<void> {
    const wished = session.breakpoints.value;
    const lines = await accepted(engine, wished);
    // Others have been wished for meanwhile.
    if (session.breakpoints.value === wished) changeSession({ breakpoints: lines });
  }

  #changeHistory(): void {
    changeSession({ history: session.history.peek() + 1 });
  }

  // --- Walks -------------------------------------------------------------------------------------

  pause(): void {
    this.#run?.abort();
    this.#walk?.abort();
  }

  /** Runs at the speed that the reader has chosen, until something stops it; after the end anew. */
  run(): Promise<void> {
    const control = new AbortController();
    const done = this.#walking(async (engine, signal) => {
      const { value: before } = session.notice;
      const hasEnded = before.kind === "stopped" && before.stop.reason === "end";
      if (hasEnded) await this.#show(await engine.goTo({ moment: 0 }));
      changeSession({ notice: { kind: "running" } });
      let last = performance.now();
      while (!signal.aborted) {
        await nextFrame();
        const now = performance.now();
        // A page that was hidden does not run to catch up.
        const passed = Math.min(now - last, 100);
        last = now;
        const result =
          settings.speed.value === Infinity
            ? await this.#fast(engine)
            : await engine.forward(
                { goal: "end", ms: Math.max(passed * settings.speed.value, 0.05) },
                stepsOfRun,
              );
        const { stop, state } = result;
        if (stop.reason !== "goal" && stop.reason !== "budget") {
          await this.#show(state, { kind: "stopped", stop });
          return;
        }
        await this.#show(state);
      }
      changeSession({ notice: { kind: "ready" } });
    }, control);
    this.#run = control;
    return done;
  }

  /** To where a run ends, with no picture on the way. */
  runToEnd(): Promise<void> {
    return this.#walking(async (engine, signal) =>
      this.#arrived(await engine.walkForward({ goal: "end" }, { signal })),
    );
  }

  /** From the present moment to a later one, past whatever stops a run, or to its end. */
  runTo(moment: number): Promise<void> {
    return this.#walking(async (engine, signal) => {
      let state = await engine.state();
      while (state.moment < moment && !signal.aborted) {
        const steps = Math.min(moment - state.moment, stepsOfRun);
        const result = await engine.forward({ goal: "end" }, steps);
        const isOver = result.stop.reason === "end" || result.state.moment === state.moment;
        if (isOver) return this.#arrived(result);
        ({ state } = result);
      }
      return this.#show(state, { kind: "ready" });
    });
  }

  /** As far as it gets until the next picture is due. */
  async #fast(engine: Engine): Promise<WalkResult> {
    const begin = performance.now();
    for (;;) {
      const result = await engine.forward({ goal: "end" }, stepsOfRun);
      if (result.stop.reason !== "budget" || performance.now() - begin > 60) return result;
    }
  }

  /** One statement, whichever thread is next; if no thread runs, a call of the host or a cycle. */
  stepStatement(): Promise<void> {
    return this.#walking(async (engine, signal) => {
      let { state } = { state: await engine.state() };
      if (!state.threads.some((thread) => thread.state === "running")) {
        return this.#arrived(await engine.forward({ goal: state.host ? "call" : "cycle" }));
      }
      for (let steps = 0; steps < stepsToStatement && !signal.aborted; ++steps) {
        const isStatement = state.next === "statement";
        const result = await engine.forward({ goal: "step" });
        if (isStatement || result.stop.reason !== "goal") return this.#arrived(result);
        state = result.state;
      }
      return this.#show(state, { kind: "ready" });
    });
  }

  /** To before the last statement, or the last call or cycle if none was executed. */
  stepBack(): Promise<void> {
    return this.#walking(async (engine) => {
      const { host, threads, moment } = await engine.state();
      if (!threads.some((thread) => thread.statements > 0)) {
        return this.#arrived(await engine.back({ goal: host ? "call" : "cycle" }));
      }
      const last = await lastStatement(engine, moment);
      return this.#show(await engine.goTo({ moment: last }), { kind: "ready" });
    });
  }

  cycle(): Promise<void> {
    return this.#walking(async (engine) => this.#arrived(await engine.forward({ goal: "cycle" })));
  }

  cycleBack(): Promise<void> {
    return this.#walking(async (engine) => this.#arrived(await engine.back({ goal: "cycle" })));
  }

  /** To a moment that has been reached, or to a time. */
  goTo(place: { moment: number } | { ms: number }): Promise<void> {
    return this.#walking(async (engine) => this.#show(await engine.goTo(place), { kind: "ready" }));
  }

  /** Lets a thread execute the next statement, whatever the schedule says. */
  stepThread(thread: number): Promise<void> {
    return this.#walking(async (engine) => {
      this.#changeHistory();
      await this.#arrived(await engine.stepThread(thread));
    });
  }

  setInput(type: string, index: number, level: number): Promise<void> {
    return this.#changing((engine) => engine.setInput(type, index, level));
  }

  write(name: string, value: number): Promise<void> {
    return this.#changing((engine) => engine.write(name, value));
  }

  #changing(change: (engine: Engine) => Promise<State>): Promise<void> {
    // A change while the card runs does not stop it.
    return this.#then(async (engine) => {
      this.#changeHistory();
      await this.#show(await change(engine));
    }, true);
  }

  // --- Order -------------------------------------------------------------------------------------

  /** Does a walk after those before. */
  #walking(
    walk: (engine: Engine, signal: AbortSignal) => Promise<void>,
    control = new AbortController(),
  ): Promise<void> {
    return this.#then(async (engine) => {
      if (!present.state.peek()) return;
      this.#walk = control;
      changeSession({ running: true });
      try {
        await walk(engine, control.signal);
      } finally {
        if (this.#walk === control) this.#walk = undefined;
        changeSession({ running: false });
      }
    });
  }

  /** One after the other; refusals are said, the end of the engine has been. */
  #then(work: (engine: Engine) => Promise<void>, besides = false): Promise<void> {
    if (!besides) this.#run?.abort();
    const after = besides ? Promise.resolve() : Promise.all([this.#work, this.#changes]);
    const done = after.then(async () => {
      try {
        await work(await this.engine());
      } catch (error) {
        if (error instanceof RefusedError) {
          changeSession({ notice: { kind: "refused", message: error.message } });
        }
      }
    });
    if (besides) this.#changes = Promise.all([this.#changes, done]);
    else this.#work = done;
    return done;
  }

  #arrived({ stop, state }: WalkResult): Promise<void> {
    return this.#show(
      state,
      stop.reason === "goal" ? { kind: "ready" } : { kind: "stopped", stop },
    );
  }

  async #show(state: State, notice?: Notice): Promise<void> {
    const engine = await this.engine();
    const pages = [...new Set(state.threads.map(({ page }) => page))];
    const [card, globals, ...locals] = await Promise.all([
      engine.card(),
      engine.variables(),
      ...pages.map((page) => engine.variables(page)),
    ]);
    batch(() => {
      if (state.head < this.#head) this.#changeHistory();
      this.#head = state.head;
      changePresent({
        state,
        card,
        globals,
        locals: new Map(pages.map((page, index) => [page, locals[index] ?? []])),
      });
      if (notice) changeSession({ notice });
    });
  }
}

export const bench = new Bench();

/** The moment of the last statement before another one; 0 if there is none. */
async function lastStatement(engine: Engine, before: number): Promise<number> {
  for (let to = before, length = firstLook; to > 0; to -= length, length *= 4) {
    const turns = await engine.turns(Math.max(0, to - length), to, length);
    const last = turns.at(-1);
    if (last) return last.moment + last.statements - 1;
  }
  return 0;
}

/** The lines of breakpoints that the engine has set. Behind the last statement there is none. */
async function accepted(engine: Engine, wished: readonly number[]): Promise<number[]> {
  const last = Math.max(0, ...(await engine.listing()).flatMap(linesOf));
  const { lines } = await engine.setStops({
    lines: wished.filter((line) => line <= last).map((line) => ({ line })),
  });
  return [...new Set(lines)].sort((a, b) => a - b);
}

function linesOf({ statements }: ListedFunction): number[] {
  return statements.map(({ line }) => line);
}

/** The next picture; a hidden page draws none. */
function nextFrame(): Promise<void> {
  return new Promise((resume) => {
    const timer = setTimeout(resume, 100);
    requestAnimationFrame(() => {
      clearTimeout(timer);
      resume();
    });
  });
}
