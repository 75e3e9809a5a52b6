// The debug adapter: requests of an editor in the Debug Adapter Protocol, answered by an engine.
// It knows nothing about programs; docs/debugger.md says what its steps mean.
// Tested by test/*.test.ts.

import { writeFile } from "node:fs/promises";
import { basename, dirname, join } from "node:path";

import {
  type Compiled,
  type Diagnostic,
  type Engine,
  type Evaluation,
  type Language,
  RefusedError,
  type State,
  type Thread,
  type WalkResult,
} from "@oncard/engine";
import {
  ContinuedEvent,
  DebugSession,
  type Event,
  ExitedEvent,
  InitializedEvent,
  OutputEvent,
  Source,
  StackFrame,
  StoppedEvent,
  TerminatedEvent,
  Thread as EditorThread,
} from "@vscode/debugadapter";
import type { DebugProtocol } from "@vscode/debugprotocol";

import { Code } from "./code.js";
import { type Command, commandHelp, readCommand } from "./console.js";
import { type LaunchConfig, readLaunchConfig } from "./launch.js";
import { bytesOf, readPlace } from "./memory.js";
import { back, forward, type Movement, toNextStop, turnOf } from "./movements.js";
import { startEngine } from "./start.js";
import { type Filter, readHits, Stops, usualFilters, type Wish } from "./stops.js";
import { describeStop, languageOf, type Text, UserError } from "./texts.js";
import { numberOf, Variables } from "./variables.js";
import { judge, type Verdict } from "./verdict.js";

/** What exists from a successful launch on. */
interface Launched {
  config: LaunchConfig;
  engine: Engine;
  code: Code;
  variables: Variables;
  state: State;
}

const exceptionReasons = new Set(["fault", "refusal", "requirement", "race"]);

export class OncardSession extends DebugSession {
  readonly #environment: Readonly<Record<string, string | undefined>>;
  readonly #stops = new Stops();
  #language: Language = "en";
  #launched: Launched | undefined;
  /** While the card moves: ends the movement. */
  #moving: AbortController | undefined;
  #last: WalkResult["stop"] | undefined;
  #verdict: Verdict | undefined;

  constructor(environment: Readonly<Record<string, string | undefined>>) {
    super();
    this.#environment = environment;
    this.setDebuggerLinesStartAt1(true);
    this.setDebuggerColumnsStartAt1(true);
  }

  // --- Beginning and end -------------------------------------------------------------------------

  /** The library refuses to begin without a path format, for which the protocol has a default. */
  protected override dispatchRequest(request: DebugProtocol.Request): void {
    if (request.command === "initialize") {
      const args = request.arguments as object | undefined;
      request.arguments = { pathFormat: "path", ...args };
    }
    super.dispatchRequest(request);
  }

  protected override initializeRequest(
    response: DebugProtocol.InitializeResponse,
    args: DebugProtocol.InitializeRequestArguments,
  ): void {
    this.#language = languageOf(args.locale);
    const filter = (name: Filter, label: Text) => ({
      filter: name,
      label: this.#say(label),
      default: usualFilters.includes(name),
    });
    response.body = {
      supportsConfigurationDoneRequest: true,
      supportsTerminateRequest: true,
      supportsConditionalBreakpoints: true,
      supportsHitConditionalBreakpoints: true,
      supportsLogPoints: true,
      supportsFunctionBreakpoints: true,
      supportsDataBreakpoints: true,
      supportsExceptionInfoRequest: true,
      exceptionBreakpointFilters: [
        filter("fault", { en: "faults of threads", zh: "线程出错" }),
        filter("refusal", { en: "refused commands", zh: "命令被拒绝" }),
        filter("requirement", { en: "requirements that do not hold", zh: "要求不成立" }),
        filter("race", { en: "data races", zh: "数据竞争" }),
      ],
      supportsStepBack: true,
      supportsSteppingGranularity: true,
      supportsGotoTargetsRequest: true,
      supportsEvaluateForHovers: true,
      supportsSetVariable: true,
      supportsSetExpression: true,
      supportsLoadedSourcesRequest: true,
      supportsDisassembleRequest: true,
      supportsReadMemoryRequest: true,
    };
    this.sendResponse(response);
  }

  protected override launchRequest(
    response: DebugProtocol.LaunchResponse,
    args: DebugProtocol.LaunchRequestArguments,
  ): void {
    this.#answer(response, async () => {
      await this.#launch(readLaunchConfig({ ...args }, this.#environment));
      // After the response: breakpoints are asked for next.
      setImmediate(() => {
        this.sendEvent(new InitializedEvent());
      });
    });
  }

  async #launch(config: LaunchConfig): Promise<void> {
    const engine = await startEngine(config);
    try {
      await engine.hello(this.#language);
      const { program, structured } = config;
      const loaded = await engine.load({ main: program, structured });
      for (const each of loaded.diagnostics) this.#showDiagnostic(each);
      if (!loaded.compiled) throw notCompiled(loaded, program);
      const code = new Code(loaded.files, await engine.listing());
      const variables = new Variables(engine);
      this.#launched = { config, engine, code, variables, state: loaded.state };
      if (config.noDebug) this.#stops.filter([]);
      await this.#stops.install(engine);
    } catch (error) {
      engine.close();
      throw error;
    }
    engine.onLog = ({ thread, text }) => {
      this.#print(`[${thread}] ${text}\n`, "console");
    };
    engine.onEnded = (why) => {
      this.#print(`${why.message}\n`, "stderr");
      this.sendEvent(new TerminatedEvent());
    };
  }

  protected override configurationDoneRequest(
    response: DebugProtocol.ConfigurationDoneResponse,
  ): void {
    if (this.#launched?.config.stopOnEntry) {
      this.sendResponse(response);
      this.#sendStopped("entry", this.#launched.state.next_thread);
    } else {
      this.#move(response, toNextStop);
    }
  }

  protected override terminateRequest(response: DebugProtocol.TerminateResponse): void {
    this.#close();
    this.sendResponse(response);
    this.sendEvent(new TerminatedEvent());
  }

  protected override disconnectRequest(response: DebugProtocol.DisconnectResponse): void {
    this.#close();
    this.sendResponse(response);
    this.shutdown();
  }

  #close(): void {
    this.#launched?.engine.close();
  }

  // --- Moving ------------------------------------------------------------------------------------

  protected override continueRequest(response: DebugProtocol.ContinueResponse): void {
    response.body = { allThreadsContinued: true };
    if (this.#launched?.state.over) {
      this.sendResponse(response);
      // It fails if the engine has ended, which says so itself.
      this.#finish().catch(() => undefined);
    } else {
      this.#move(response, toNextStop);
    }
  }

  protected override nextRequest(
    response: DebugProtocol.NextResponse,
    { threadId, granularity }: DebugProtocol.NextArguments,
  ): void {
    const thread = threadId - 1;
    this.#move(response, forward({ goal: goalOf(granularity), thread }, thread));
  }

  protected override stepInRequest(
    response: DebugProtocol.StepInResponse,
    { threadId }: DebugProtocol.StepInArguments,
  ): void {
    const thread = threadId - 1;
    this.#move(response, forward({ goal: "statement", thread }, thread));
  }

  protected override stepOutRequest(
    response: DebugProtocol.StepOutResponse,
    { threadId }: DebugProtocol.StepOutArguments,
  ): void {
    this.#move(response, forward({ goal: "cycle" }, threadId - 1));
  }

  protected override stepBackRequest(
    response: DebugProtocol.StepBackResponse,
    { threadId, granularity }: DebugProtocol.StepBackArguments,
  ): void {
    const thread = threadId - 1;
    this.#move(response, back({ goal: goalOf(granularity), thread }, thread));
  }

  protected override reverseContinueRequest(
    response: DebugProtocol.ReverseContinueResponse,
    { threadId }: DebugProtocol.ReverseContinueArguments,
  ): void {
    this.#move(response, back({ goal: "stop" }, threadId - 1));
  }

  protected override gotoTargetsRequest(
    response: DebugProtocol.GotoTargetsResponse,
    { source, line }: DebugProtocol.GotoTargetsArguments,
  ): void {
    this.#answer(response, () => {
      const { code, state } = this.#now();
      const file = code.fileOf(source);
      const here = state.threads.filter(
        (thread) => thread.ready && thread.file === file && thread.line === line,
      );
      response.body = {
        targets: here.map((thread) => ({
          id: thread.thread,
          label: this.#say({
            en: `thread ${thread.thread} executes its next statement`,
            zh: `线程 ${thread.thread} 执行下一条语句`,
          }),
          line,
        })),
      };
    });
  }

  protected override gotoRequest(
    response: DebugProtocol.GotoResponse,
    { targetId }: DebugProtocol.GotoArguments,
  ): void {
    this.#move(response, turnOf(targetId));
  }

  protected override pauseRequest(response: DebugProtocol.PauseResponse): void {
    this.#moving?.abort();
    this.sendResponse(response);
  }

  /** Moves the card. The response is sent as soon as it is certain that the engine agrees. */
  #move(response: DebugProtocol.Response, movement: Movement): void {
    const launched = this.#launched;
    if (!launched) {
      this.#fail(response, notLaunched());
      return;
    }
    if (this.#moving) {
      this.#fail(response, new UserError({ en: "the card is running", zh: "卡正在运行" }));
      return;
    }
    const moving = new AbortController();
    this.#moving = moving;
    let answered = false;
    const onSlice = ({ state }: WalkResult) => {
      launched.state = state;
      launched.variables.reset();
      if (!answered) this.sendResponse(response);
      answered = true;
    };
    movement
      .walk(launched.engine, { signal: moving.signal, onSlice })
      .then((result) => {
        this.#moving = undefined;
        onSlice(result);
        return this.#arrive(result, movement);
      })
      .catch((error: unknown) => {
        this.#moving = undefined;
        // An engine that has ended says so itself.
        if (!answered) this.#fail(response, error);
      });
  }

  async #arrive({ stop, state }: WalkResult, movement: Movement): Promise<void> {
    this.#last = stop;
    this.#verdict = undefined;
    if (stop.reason === "end") {
      if (this.#now().config.noDebug) {
        await this.#finish();
        return;
      }
      await this.#showVerdict();
    }
    const text = describeStop(stop, state);
    if (text) this.#print(`${this.#say(text)}\n`, "console");
    const thread = stop.thread ?? movement.thread ?? state.next_thread;
    this.#sendStopped(this.#reasonOf(stop, movement), thread, text, this.#stops.reached(stop));
  }

  #reasonOf({ reason }: WalkResult["stop"], movement: Movement): string {
    if (exceptionReasons.has(reason)) return "exception";
    if (reason === "line") return "breakpoint";
    if (reason === "change") return "data breakpoint";
    if (reason === "start") return "entry";
    if (reason === "budget") return "pause";
    return movement.reason;
  }

  #sendStopped(reason: string, thread?: number, text?: Text, breakpoint?: number): void {
    const first = this.#now().state.threads[0]?.thread;
    const shown = thread ?? first;
    const event = new StoppedEvent(reason, shown === undefined ? undefined : shown + 1);
    const body: DebugProtocol.StoppedEvent["body"] = event.body;
    body.allThreadsStopped = true;
    if (text) {
      body.description = this.#say(text);
      body.text = this.#say(text);
    }
    if (breakpoint !== undefined) body.hitBreakpointIds = [breakpoint];
    this.sendEvent(event);
  }

  /** The user goes on where the run is over. */
  async #finish(): Promise<void> {
    const { exitCode } = this.#verdict ?? (await this.#showVerdict());
    this.sendEvent(new ExitedEvent(exitCode));
    this.sendEvent(new TerminatedEvent());
  }

  async #showVerdict(): Promise<Verdict> {
    const { engine, config } = this.#now();
    this.#verdict = await judge(engine, config);
    const { exitCode, text } = this.#verdict;
    this.#print(`${this.#say(text)}\n`, exitCode === 0 ? "stdout" : "stderr");
    return this.#verdict;
  }

  // --- Breakpoints -------------------------------------------------------------------------------

  protected override setBreakPointsRequest(
    response: DebugProtocol.SetBreakpointsResponse,
    { source, breakpoints }: DebugProtocol.SetBreakpointsArguments,
  ): void {
    this.#answer(response, async () => {
      const file = this.#now().code.fileOf(source);
      const wishes = (breakpoints ?? []).map((each) => this.#lineWish(file, each));
      const group = this.#stops.replace(`source ${source.path ?? source.name ?? ""}`, wishes);
      await this.#install();
      response.body = { breakpoints: group.map((wish) => this.#shownWish(wish, source)) };
    });
  }

  #lineWish(
    file: string | undefined,
    { line, condition, hitCondition, logMessage }: DebugProtocol.SourceBreakpoint,
  ): Omit<Wish, "id"> {
    if (file === undefined) {
      const refused = {
        en: "no statement of the program is in this file",
        zh: "程序中没有语句在此文件中",
      };
      return { refused: this.#say(refused) };
    }
    const hits = hitCondition ? readHits(hitCondition) : 0;
    if (hits === undefined) {
      const refused = {
        en: `the hit condition '${hitCondition ?? ""}' must be a number: stop from this arrival on`,
        zh: `命中条件“${hitCondition ?? ""}”应为数字：从该次到达起停止`,
      };
      return { refused: this.#say(refused) };
    }
    const texts = { condition: condition ?? "", log: logMessage ?? "" };
    return { at: { line: { file, line, hits, ...texts } } };
  }

  protected override setFunctionBreakPointsRequest(
    response: DebugProtocol.SetFunctionBreakpointsResponse,
    { breakpoints }: DebugProtocol.SetFunctionBreakpointsArguments,
  ): void {
    this.#answer(response, async () => {
      const { code } = this.#now();
      const wishes = breakpoints.map(({ name, condition }) => {
        const beginning = code.beginning(name);
        const refused = { en: `there is no function '${name}'`, zh: `没有函数“${name}”` };
        return beginning
          ? { at: { line: { ...beginning, condition: condition ?? "" } } }
          : { refused: this.#say(refused) };
      });
      const group = this.#stops.replace("functions", wishes);
      await this.#install();
      response.body = { breakpoints: group.map((wish) => this.#shownWish(wish)) };
    });
  }

  protected override dataBreakpointInfoRequest(
    response: DebugProtocol.DataBreakpointInfoResponse,
    { variablesReference, name, frameId }: DebugProtocol.DataBreakpointInfoArguments,
  ): void {
    this.#answer(response, async () => {
      const path = variablesReference
        ? await this.#now().variables.path(variablesReference, name)
        : (await this.#evaluate(name, frameId)).path;
      response.body =
        path === undefined
          ? { dataId: null, description: this.#say({ en: "this has no name", zh: "此项没有名称" }) }
          : { dataId: path, description: path, accessTypes: ["write"], canPersist: true };
    });
  }

  protected override setDataBreakpointsRequest(
    response: DebugProtocol.SetDataBreakpointsResponse,
    { breakpoints }: DebugProtocol.SetDataBreakpointsArguments,
  ): void {
    this.#answer(response, async () => {
      const wishes = breakpoints.map(({ dataId }) => ({ at: { change: dataId } }));
      const group = this.#stops.replace("changes", wishes);
      await this.#install();
      response.body = { breakpoints: group.map((wish) => this.#shownWish(wish)) };
    });
  }

  protected override setExceptionBreakPointsRequest(
    response: DebugProtocol.SetExceptionBreakpointsResponse,
    { filters }: DebugProtocol.SetExceptionBreakpointsArguments,
  ): void {
    this.#answer(response, async () => {
      this.#stops.filter(filters);
      await this.#install();
    });
  }

  protected override exceptionInfoRequest(response: DebugProtocol.ExceptionInfoResponse): void {
    this.#answer(response, () => {
      const { state } = this.#now();
      const text = this.#last && describeStop(this.#last, state);
      response.body = {
        exceptionId: this.#last?.reason ?? "",
        description: text ? this.#say(text) : "",
        breakMode: "always",
      };
    });
  }

  /** A run without debugging stops nowhere. */
  async #install(): Promise<void> {
    const { config, engine } = this.#now();
    if (!config.noDebug) await this.#stops.install(engine);
  }

  #shownWish({ id, line, refused }: Wish, source?: DebugProtocol.Source): DebugProtocol.Breakpoint {
    if (refused !== undefined) return { id, verified: false, message: refused };
    return {
      id,
      verified: true,
      ...(line !== undefined && source ? { line, source } : {}),
    };
  }

  // --- Looking -----------------------------------------------------------------------------------

  protected override threadsRequest(response: DebugProtocol.ThreadsResponse): void {
    const threads = this.#launched?.state.threads ?? [];
    response.body = {
      threads: threads.map(
        (each) => new EditorThread(each.thread + 1, `${each.thread} ${each.function}`),
      ),
    };
    this.sendResponse(response);
  }

  protected override stackTraceRequest(
    response: DebugProtocol.StackTraceResponse,
    { threadId }: DebugProtocol.StackTraceArguments,
  ): void {
    this.#answer(response, () => {
      const { code } = this.#now();
      const thread = this.#thread(threadId);
      const frame = new StackFrame(
        threadId,
        thread.function,
        code.source(thread.file),
        thread.line,
        1,
      );
      const address = code.addressOf(thread);
      if (address !== undefined) frame.instructionPointerReference = address;
      response.body = { stackFrames: [frame], totalFrames: 1 };
    });
  }

  protected override scopesRequest(
    response: DebugProtocol.ScopesResponse,
    { frameId }: DebugProtocol.ScopesArguments,
  ): void {
    this.#answer(response, () => {
      response.body = { scopes: this.#now().variables.scopes(this.#thread(frameId)) };
    });
  }

  protected override variablesRequest(
    response: DebugProtocol.VariablesResponse,
    { variablesReference, start, count }: DebugProtocol.VariablesArguments,
  ): void {
    this.#answer(response, async () => {
      const { variables, state } = this.#now();
      const all = await variables.children(variablesReference, state);
      const from = start ?? 0;
      response.body = { variables: count ? all.slice(from, from + count) : all.slice(from) };
    });
  }

  protected override setVariableRequest(
    response: DebugProtocol.SetVariableResponse,
    { variablesReference, name, value }: DebugProtocol.SetVariableArguments,
  ): void {
    this.#answer(response, async () => {
      const { engine, variables } = this.#now();
      response.body = { value: await variables.set(variablesReference, name, value) };
      this.#now().state = await engine.state();
    });
  }

  protected override setExpressionRequest(
    response: DebugProtocol.SetExpressionResponse,
    { expression, value, frameId }: DebugProtocol.SetExpressionArguments,
  ): void {
    this.#answer(response, async () => {
      const launched = this.#now();
      const path = (await this.#evaluate(expression, frameId)).path ?? expression;
      launched.state = await launched.engine.write(path, numberOf(value));
      launched.variables.forgetValues();
      response.body = { value: shownEvaluation(await launched.engine.evaluate(path)) };
    });
  }

  protected override evaluateRequest(
    response: DebugProtocol.EvaluateResponse,
    { expression, frameId, context }: DebugProtocol.EvaluateArguments,
  ): void {
    const command = context === "repl" ? readCommand(expression) : undefined;
    if (command) {
      this.#execute(response, command);
      return;
    }
    this.#answer(response, async () => {
      const { evaluation, path } = await this.#evaluate(expression, frameId);
      if (path === undefined || !("value" in evaluation)) {
        response.body = { result: shownEvaluation(evaluation), variablesReference: 0 };
        return;
      }
      const { value, ...rest } = this.#now().variables.shown(path, evaluation.value);
      response.body = { result: value, ...rest };
    });
  }

  /** A name of the program is first looked for among the locals of the frame. */
  async #evaluate(
    text: string,
    frameId?: number,
  ): Promise<{ evaluation: Evaluation; path: string | undefined }> {
    const { engine } = this.#now();
    if (frameId !== undefined && /^[A-Za-z_]\w*(?:\[\d+\])?$/.test(text)) {
      const path = `page${this.#thread(frameId).page}.${text}`;
      try {
        return { evaluation: await engine.evaluate(path), path };
      } catch (error) {
        if (!(error instanceof RefusedError)) throw error;
      }
    }
    const evaluation = await engine.evaluate(text);
    return { evaluation, path: "value" in evaluation ? text : undefined };
  }

  #execute(response: DebugProtocol.EvaluateResponse, command: Command): void {
    response.body = { result: "", variablesReference: 0 };
    switch (command.do) {
      case "help":
        response.body.result = this.#say(commandHelp);
        this.sendResponse(response);
        break;
      case "record":
        this.#answer(response, async () => {
          response.body = { result: await this.#record(command.file), variablesReference: 0 };
        });
        break;
      case "cycle":
        this.#moveFromConsole(response, forward({ goal: "cycle" }));
        break;
      case "rest":
        this.#moveFromConsole(response, forward({ goal: "rest" }));
        break;
      case "thread":
        this.#moveFromConsole(response, turnOf(command.thread));
        break;
      case "back":
        this.#moveFromConsole(response, back({ goal: "change", name: command.name }));
    }
  }

  /** The editor does not expect the card to move: it is told when that takes long. */
  #moveFromConsole(response: DebugProtocol.Response, movement: Movement): void {
    let told = false;
    this.#move(response, {
      ...movement,
      walk: (engine, { onSlice, ...options }) =>
        movement.walk(engine, {
          ...options,
          onSlice: (result) => {
            onSlice?.(result);
            if (!told) this.sendEvent(new ContinuedEvent(1, true));
            told = true;
          },
        }),
    });
  }

  /** Writes a recording beside the program, from where the schedule file names it. */
  async #record(file: string): Promise<string> {
    if (basename(file) !== file) {
      throw new UserError({
        en: `'${file}' must be a name without a folder: a recording is kept beside its program`,
        zh: `“${file}”应为不含目录的文件名：记录保存在程序所在目录`,
      });
    }
    const { engine, config } = this.#now();
    const { schedule } = await engine.record();
    const path = join(dirname(config.program), file);
    try {
      await writeFile(path, schedule);
    } catch (error) {
      const why = error instanceof Error ? error.message : "";
      throw new UserError({
        en: `cannot write '${path}': ${why}`,
        zh: `无法写入“${path}”：${why}`,
      });
    }
    return path;
  }

  protected override loadedSourcesRequest(response: DebugProtocol.LoadedSourcesResponse): void {
    this.#answer(response, () => {
      response.body = { sources: this.#now().code.sources() };
    });
  }

  protected override sourceRequest(
    response: DebugProtocol.SourceResponse,
    { source }: DebugProtocol.SourceArguments,
  ): void {
    this.#answer(response, () => {
      const content = source && this.#now().code.text(source);
      if (content === undefined) {
        throw new UserError({ en: "this is no file of the program", zh: "这不是程序的文件" });
      }
      response.body = { content };
    });
  }

  protected override disassembleRequest(
    response: DebugProtocol.DisassembleResponse,
    {
      memoryReference,
      offset,
      instructionOffset,
      instructionCount,
    }: DebugProtocol.DisassembleArguments,
  ): void {
    this.#answer(response, () => {
      const first = Number(memoryReference) + (offset ?? 0) + (instructionOffset ?? 0);
      response.body = { instructions: this.#now().code.disassemble(first, instructionCount) };
    });
  }

  protected override readMemoryRequest(
    response: DebugProtocol.ReadMemoryResponse,
    { memoryReference, offset, count }: DebugProtocol.ReadMemoryArguments,
  ): void {
    this.#answer(response, async () => {
      const place = readPlace(memoryReference);
      if (!place) {
        throw new UserError({
          en: `'${memoryReference}' is no data page: page0 to page31`,
          zh: `“${memoryReference}”不是数据页：应为 page0 至 page31`,
        });
      }
      const from = place.offset + (offset ?? 0);
      const bytes = bytesOf(await this.#now().engine.slots(place.page), from, count);
      response.body = {
        address: `0x${Math.max(0, from).toString(16)}`,
        data: bytes.toString("base64"),
        unreadableBytes: count - bytes.length,
      };
    });
  }

  // --- Answers -----------------------------------------------------------------------------------

  #now(): Launched {
    if (this.#launched) return this.#launched;
    throw notLaunched();
  }

  /** The card's thread with the editor's id of it or of its frame: 1 is added to its number. */
  #thread(id: number): Thread {
    const found = this.#now().state.threads.find(({ thread }) => thread === id - 1);
    if (found) return found;
    throw new UserError({ en: `there is no thread ${id - 1}`, zh: `没有线程 ${id - 1}` });
  }

  /** Sends the response when the work is done. */
  #answer(response: DebugProtocol.Response, work: () => Promise<void> | void): void {
    Promise.resolve()
      .then(work)
      .then(() => {
        this.sendResponse(response);
      })
      .catch((error: unknown) => {
        this.#fail(response, error);
      });
  }

  #fail(response: DebugProtocol.Response, error: unknown): void {
    const text =
      error instanceof UserError
        ? this.#say(error.text)
        : error instanceof Error
          ? error.message
          : "";
    // The braces of a message are no variables. Names that begin otherwise are left out of it.
    this.sendErrorResponse(response, {
      id: 1,
      format: "{_text}",
      variables: { _text: text },
      showUser: true,
    });
  }

  #say(text: Text): string {
    return text[this.#language];
  }

  #print(text: string, category: "console" | "stdout" | "stderr"): void {
    this.sendEvent(new OutputEvent(text, category));
  }

  #showDiagnostic({ file, line, column, severity, message }: Diagnostic): void {
    const place = `${file}:${line}:${column}`;
    const event: Event & DebugProtocol.OutputEvent = new OutputEvent(
      `${place}: ${severity}: ${message}\n`,
      severity === "error" ? "stderr" : "console",
    );
    event.body.source = new Source(basename(file), file);
    event.body.line = line;
    event.body.column = column;
    this.sendEvent(event);
  }
}

function goalOf(granularity: DebugProtocol.SteppingGranularity | undefined): "statement" | "line" {
  return granularity === "instruction" ? "statement" : "line";
}

function notLaunched(): UserError {
  return new UserError({ en: "nothing has been launched", zh: "尚未启动程序" });
}

function notCompiled({ diagnostics }: Compiled, program: string): UserError {
  const first = diagnostics.find(({ severity }) => severity === "error");
  const why = first ? `${first.file}:${first.line}:${first.column}: ${first.message}` : "";
  return new UserError({
    en: `${program} was not compiled: ${why}`,
    zh: `${program} 未能编译：${why}`,
  });
}

function shownEvaluation(evaluation: Evaluation): string {
  return String("value" in evaluation ? evaluation.value : evaluation.holds);
}
