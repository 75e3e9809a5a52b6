// The debug adapter: requests of an editor in the Debug Adapter Protocol, answered by an engine.
// It knows nothing about programs; docs/debugger.md says what its steps mean. This file takes the
// requests apart; what they do is in the files beside it.
// Tested by test/*.test.ts.

import { languageOf } from "@oncard/engine";
import { DebugSession, InitializedEvent, TerminatedEvent, Thread } from "@vscode/debugadapter";
import type { DebugProtocol } from "@vscode/debugprotocol";

import { Breakpoints } from "./breakpoints.js";
import { capabilities } from "./capabilities.js";
import { complete } from "./completions.js";
import { type Command, commandHelp, movementOf, readCommand } from "./console.js";
import { customRequests } from "./custom_requests.js";
import { Editor } from "./editor.js";
import { evaluate, setExpression, setVariable } from "./evaluation.js";
import { readConfig } from "./launch.js";
import { hostThread, toLastCall, toNextCall } from "./host.js";
import { launch, type Launched, notLaunched, threadOf } from "./launched.js";
import { readMemory } from "./memory.js";
import { Mover } from "./mover.js";
import { back, forward, type Movement, toNextStop, turnOf } from "./movements.js";
import { record } from "./recording.js";
import { statementsUntil, toStatement } from "./statements.js";
import { Stops } from "./stops.js";
import { UserError } from "./texts.js";

export class OncardSession extends DebugSession {
  readonly #environment: Readonly<Record<string, string | undefined>>;
  readonly #editor: Editor;
  readonly #stops = new Stops();
  readonly #breakpoints: Breakpoints;
  readonly #mover: Mover;
  #launched: Launched | undefined;

  constructor(environment: Readonly<Record<string, string | undefined>>) {
    super();
    this.#environment = environment;
    this.#editor = new Editor({
      sendResponse: (response) => {
        this.sendResponse(response);
      },
      sendEvent: (event) => {
        this.sendEvent(event);
      },
      sendFailure: (response, why) => {
        // The braces of a message are no variables. Names that begin otherwise are left out of it.
        const variables = { _text: why };
        this.sendErrorResponse(response, { id: 1, format: "{_text}", variables, showUser: true });
      },
    });
    this.#breakpoints = new Breakpoints(this.#editor, this.#stops);
    this.#mover = new Mover(this.#editor, this.#stops);
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
    this.#editor.language = languageOf(args.locale);
    this.#editor.takesInvalidated = args.supportsInvalidatedEvent ?? false;
    response.body = capabilities(this.#editor);
    this.sendResponse(response);
  }

  protected override launchRequest(
    response: DebugProtocol.LaunchResponse,
    args: DebugProtocol.LaunchRequestArguments,
  ): void {
    this.#launch(response, { ...args });
  }

  /** A host program is run to its end and recorded; what it did can then be walked through. */
  protected override attachRequest(
    response: DebugProtocol.AttachResponse,
    args: DebugProtocol.AttachRequestArguments,
  ): void {
    this.#launch(response, { ...args });
  }

  #launch(response: DebugProtocol.Response, args: Readonly<Record<string, unknown>>): void {
    this.#editor.answer(response, async () => {
      const config = readConfig(args, this.#environment);
      this.#launched = await launch(config, this.#stops, this.#editor);
      // After the response: breakpoints are asked for next.
      setImmediate(() => {
        this.sendEvent(new InitializedEvent());
      });
    });
  }

  protected override configurationDoneRequest(
    response: DebugProtocol.ConfigurationDoneResponse,
  ): void {
    this.#begin(response);
  }

  #begin(response: DebugProtocol.Response): void {
    const { stopOnEntry, stopAtStatement, noDebug } = this.#launched?.config ?? {};
    if (this.#launched && stopOnEntry) {
      this.sendResponse(response);
      this.#mover.enter(this.#launched);
    } else if (stopAtStatement !== undefined && !noDebug) {
      this.#move(response, toStatement(stopAtStatement));
    } else {
      this.#move(response, toNextStop);
    }
  }

  /** A program that cannot be launched leaves the card as it is. */
  protected override restartRequest(
    response: DebugProtocol.RestartResponse,
    args: DebugProtocol.RestartArguments | undefined,
  ): void {
    const restart = async () => {
      const before = this.#now();
      const given = args?.arguments;
      const config = given ? readConfig({ ...given }, this.#environment) : before.config;
      const launched = await launch(config, this.#stops, this.#editor);
      this.#mover.abandon();
      before.engine.close();
      this.#launched = launched;
      await this.#breakpoints.renew(launched);
      this.#begin(response);
    };
    restart().catch((error: unknown) => {
      this.#editor.fail(response, error);
    });
  }

  protected override terminateRequest(response: DebugProtocol.TerminateResponse): void {
    this.#launched?.engine.close();
    this.sendResponse(response);
    this.sendEvent(new TerminatedEvent());
  }

  protected override disconnectRequest(response: DebugProtocol.DisconnectResponse): void {
    this.#launched?.engine.close();
    this.sendResponse(response);
    this.shutdown();
  }

  // --- Moving ------------------------------------------------------------------------------------

  protected override continueRequest(response: DebugProtocol.ContinueResponse): void {
    response.body = { allThreadsContinued: true };
    if (this.#launched?.state.over) {
      this.sendResponse(response);
      // It fails if the engine has ended, which says so itself.
      this.#mover.finish(this.#launched).catch(() => undefined);
    } else {
      this.#move(response, toNextStop);
    }
  }

  protected override nextRequest(
    response: DebugProtocol.NextResponse,
    { threadId, granularity }: DebugProtocol.NextArguments,
  ): void {
    const thread = threadId - 1;
    const step = () => forward({ goal: goalOf(granularity), thread }, thread);
    this.#move(response, thread === hostThread ? toNextCall : step());
  }

  protected override stepInRequest(
    response: DebugProtocol.StepInResponse,
    { threadId }: DebugProtocol.StepInArguments,
  ): void {
    const thread = threadId - 1;
    const step = () => forward({ goal: "statement", thread }, thread);
    this.#move(response, thread === hostThread ? toNextCall : step());
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
    const step = () => back({ goal: goalOf(granularity), thread }, thread);
    this.#move(response, thread === hostThread ? toLastCall : step());
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
    this.#editor.answer(response, () => {
      const { code, state } = this.#now();
      const file = code.fileOf(source);
      const here = state.threads.filter(
        (thread) => thread.ready && thread.file === file && thread.line === line,
      );
      const label = (thread: number) =>
        this.#editor.say({
          en: `thread ${thread} executes its next statement`,
          zh: `线程 ${thread} 执行下一条语句`,
        });
      const targets = here.map(({ thread }) => ({ id: thread, label: label(thread), line }));
      response.body = { targets };
    });
  }

  protected override gotoRequest(
    response: DebugProtocol.GotoResponse,
    { targetId }: DebugProtocol.GotoArguments,
  ): void {
    this.#move(response, turnOf(targetId));
  }

  protected override pauseRequest(response: DebugProtocol.PauseResponse): void {
    this.#mover.pause();
    this.sendResponse(response);
  }

  #move(response: DebugProtocol.Response, movement: Movement): void {
    if (this.#launched) this.#mover.move(this.#launched, response, movement);
    else this.#editor.fail(response, notLaunched());
  }

  // --- Breakpoints -------------------------------------------------------------------------------

  protected override setBreakPointsRequest(
    response: DebugProtocol.SetBreakpointsResponse,
    args: DebugProtocol.SetBreakpointsArguments,
  ): void {
    this.#editor.answer(response, async () => {
      response.body = { breakpoints: await this.#breakpoints.setLines(this.#now(), args) };
    });
  }

  protected override setFunctionBreakPointsRequest(
    response: DebugProtocol.SetFunctionBreakpointsResponse,
    args: DebugProtocol.SetFunctionBreakpointsArguments,
  ): void {
    this.#editor.answer(response, async () => {
      response.body = { breakpoints: await this.#breakpoints.setFunctions(this.#now(), args) };
    });
  }

  protected override dataBreakpointInfoRequest(
    response: DebugProtocol.DataBreakpointInfoResponse,
    args: DebugProtocol.DataBreakpointInfoArguments,
  ): void {
    this.#editor.answer(response, async () => {
      response.body = await this.#breakpoints.dataInfo(this.#now(), args);
    });
  }

  protected override setDataBreakpointsRequest(
    response: DebugProtocol.SetDataBreakpointsResponse,
    args: DebugProtocol.SetDataBreakpointsArguments,
  ): void {
    this.#editor.answer(response, async () => {
      response.body = { breakpoints: await this.#breakpoints.setData(this.#now(), args) };
    });
  }

  protected override setInstructionBreakpointsRequest(
    response: DebugProtocol.SetInstructionBreakpointsResponse,
    args: DebugProtocol.SetInstructionBreakpointsArguments,
  ): void {
    this.#editor.answer(response, async () => {
      response.body = { breakpoints: await this.#breakpoints.setInstructions(this.#now(), args) };
    });
  }

  protected override setExceptionBreakPointsRequest(
    response: DebugProtocol.SetExceptionBreakpointsResponse,
    { filters }: DebugProtocol.SetExceptionBreakpointsArguments,
  ): void {
    this.#editor.answer(response, () => this.#breakpoints.setExceptions(this.#now(), filters));
  }

  protected override exceptionInfoRequest(response: DebugProtocol.ExceptionInfoResponse): void {
    this.#editor.answer(response, () => {
      response.body = this.#mover.exception(this.#now());
    });
  }

  // --- Looking and changing ----------------------------------------------------------------------

  protected override threadsRequest(response: DebugProtocol.ThreadsResponse): void {
    const state = this.#launched?.state;
    const threads = (state?.threads ?? []).map(
      (each) => new Thread(each.thread + 1, `${each.thread} ${each.function}`),
    );
    if (state?.host) {
      const name = this.#editor.say({ en: "host", zh: "主机" });
      threads.push(new Thread(hostThread + 1, name));
    }
    response.body = { threads };
    this.sendResponse(response);
  }

  protected override stackTraceRequest(
    response: DebugProtocol.StackTraceResponse,
    { threadId }: DebugProtocol.StackTraceArguments,
  ): void {
    this.#editor.answer(response, () => {
      const launched = this.#now();
      const frame = launched.code.frame(threadId, threadOf(launched, threadId));
      response.body = { stackFrames: [frame], totalFrames: 1 };
    });
  }

  protected override scopesRequest(
    response: DebugProtocol.ScopesResponse,
    { frameId }: DebugProtocol.ScopesArguments,
  ): void {
    this.#editor.answer(response, () => {
      const launched = this.#now();
      response.body = { scopes: launched.variables.scopes(threadOf(launched, frameId)) };
    });
  }

  protected override variablesRequest(
    response: DebugProtocol.VariablesResponse,
    { variablesReference, start, count }: DebugProtocol.VariablesArguments,
  ): void {
    this.#editor.answer(response, async () => {
      const { variables, state } = this.#now();
      const all = await variables.children(variablesReference, state);
      const from = start ?? 0;
      response.body = { variables: count ? all.slice(from, from + count) : all.slice(from) };
    });
  }

  protected override setVariableRequest(
    response: DebugProtocol.SetVariableResponse,
    args: DebugProtocol.SetVariableArguments,
  ): void {
    this.#editor.answer(response, async () => {
      response.body = { value: await setVariable(this.#now(), args) };
    });
  }

  protected override setExpressionRequest(
    response: DebugProtocol.SetExpressionResponse,
    args: DebugProtocol.SetExpressionArguments,
  ): void {
    this.#editor.answer(response, async () => {
      response.body = { value: await setExpression(this.#now(), args) };
    });
  }

  protected override evaluateRequest(
    response: DebugProtocol.EvaluateResponse,
    args: DebugProtocol.EvaluateArguments,
  ): void {
    const command = args.context === "repl" ? readCommand(args.expression) : undefined;
    if (command) {
      this.#execute(response, command);
      return;
    }
    this.#editor.answer(response, async () => {
      response.body = await evaluate(this.#now(), args);
    });
  }

  #execute(response: DebugProtocol.EvaluateResponse, command: Command): void {
    const result = (text: string) => ({ result: text, variablesReference: 0 });
    switch (command.do) {
      case "help":
        response.body = result(this.#editor.say(commandHelp));
        this.sendResponse(response);
        break;
      case "count":
        this.#editor.answer(response, async () => {
          const { engine, state } = this.#now();
          response.body = result(String(await statementsUntil(engine, state)));
        });
        break;
      case "record":
        this.#editor.answer(response, async () => {
          response.body = result(await record(this.#now(), command.file));
        });
        break;
      default:
        response.body = result("");
        if (this.#launched) {
          this.#mover.moveFromConsole(this.#launched, response, movementOf(command));
        } else {
          this.#editor.fail(response, notLaunched());
        }
    }
  }

  protected override completionsRequest(
    response: DebugProtocol.CompletionsResponse,
    { text, line, column, frameId }: DebugProtocol.CompletionsArguments,
  ): void {
    this.#editor.answer(response, async () => {
      const found = await complete(this.#now(), {
        text,
        line: line === undefined ? 1 : this.convertClientLineToDebugger(line),
        column: this.convertClientColumnToDebugger(column),
        frameId,
      });
      const targets = found.map(({ start = 1, ...rest }) => ({
        ...rest,
        start: this.convertDebuggerColumnToClient(start),
      }));
      response.body = { targets };
    });
  }

  protected override loadedSourcesRequest(response: DebugProtocol.LoadedSourcesResponse): void {
    this.#editor.answer(response, () => {
      response.body = { sources: this.#now().code.sources() };
    });
  }

  protected override sourceRequest(
    response: DebugProtocol.SourceResponse,
    { source }: DebugProtocol.SourceArguments,
  ): void {
    this.#editor.answer(response, () => {
      const content = source && this.#now().code.text(source);
      if (content === undefined) {
        throw new UserError({ en: "this is no file of the program", zh: "这不是程序的文件" });
      }
      response.body = { content };
    });
  }

  protected override disassembleRequest(
    response: DebugProtocol.DisassembleResponse,
    args: DebugProtocol.DisassembleArguments,
  ): void {
    this.#editor.answer(response, () => {
      const offset = (args.offset ?? 0) + (args.instructionOffset ?? 0);
      const first = Number(args.memoryReference) + offset;
      response.body = { instructions: this.#now().code.disassemble(first, args.instructionCount) };
    });
  }

  protected override readMemoryRequest(
    response: DebugProtocol.ReadMemoryResponse,
    args: DebugProtocol.ReadMemoryArguments,
  ): void {
    this.#editor.answer(response, async () => {
      response.body = await readMemory(this.#now().engine, args);
    });
  }

  protected override customRequest(
    command: string,
    response: DebugProtocol.Response,
    args: unknown,
  ): void {
    const request = customRequests.get(command);
    if (!request) {
      super.customRequest(command, response, args);
      return;
    }
    this.#editor.answer(response, async () => {
      response.body = await request(this.#now(), (args ?? {}) as never, this.#editor);
    });
  }

  #now(): Launched {
    if (this.#launched) return this.#launched;
    throw notLaunched();
  }
}

function goalOf(granularity: DebugProtocol.SteppingGranularity | undefined): "statement" | "line" {
  return granularity === "instruction" ? "statement" : "line";
}
