// A client of the adapter that behaves like an editor.

import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { DebugClient } from "@vscode/debugadapter-testsupport";
import type { DebugProtocol } from "@vscode/debugprotocol";
import { onTestFinished } from "vitest";

import { oncard } from "../../engine/test/support.js";

export { oncard, sample, wasm, withoutModule } from "../../engine/test/support.js";

export const adapter = fileURLToPath(new URL("../dist/adapter.js", import.meta.url));

/** A new folder with these files; it disappears with the test. */
export function folderOf(files: Record<string, string>): string {
  const folder = mkdtempSync(join(tmpdir(), "oncard-"));
  onTestFinished(() => {
    rmSync(folder, { recursive: true });
  });
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  return folder;
}

/** A new file with a program; it disappears with the test. */
export function programOf(text: string, name = "p.c"): string {
  return join(folderOf({ [name]: text }), name);
}

/** Jogs an axis from line 6 on with its drive off; it still moves at the end of the run. */
export const unpowered =
  "int n;\nint f()\n{\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n  GT_Update(1);\n  GT_Delay(5);\n  n = 1;\n}\n";

type Stopped = DebugProtocol.StoppedEvent["body"];

export class Editor {
  readonly client: DebugClient;
  /** What was shown in the console. */
  output = "";
  readonly #stops: Stopped[] = [];
  readonly #waiting: ((body: Stopped) => void)[] = [];

  constructor(environment: Record<string, string | undefined>) {
    this.client = new DebugClient("node", adapter, "oncard", { env: environment });
    this.client.on("output", ({ body }: DebugProtocol.OutputEvent) => {
      this.output += body.output;
    });
    this.client.on("stopped", ({ body }: DebugProtocol.StoppedEvent) => {
      const waiting = this.#waiting.shift();
      if (waiting) waiting(body);
      else this.#stops.push(body);
    });
  }

  /** The next stop that has not been asked for. */
  stopped(): Promise<Stopped> {
    const stop = this.#stops.shift();
    return stop
      ? Promise.resolve(stop)
      : new Promise((resume) => {
          this.#waiting.push(resume);
        });
  }

  async initialize(args: Record<string, unknown> = {}): Promise<DebugProtocol.Capabilities> {
    const { body } = await this.client.initializeRequest({
      adapterID: "oncard",
      pathFormat: "path",
      linesStartAt1: true,
      columnsStartAt1: true,
      ...args,
    });
    return body ?? {};
  }

  /** Initializes, launches and stands where breakpoints are set. */
  async launch(
    program: string,
    config: Record<string, unknown> = {},
    client: Record<string, unknown> = {},
  ): Promise<void> {
    await this.initialize(client);
    // Together: nobody waits for the event any longer when the request fails.
    await Promise.all([
      this.client.waitForEvent("initialized"),
      this.client.launchRequest({ program, ...config } as DebugProtocol.LaunchRequestArguments),
    ]);
  }

  /** Launches and stands at the beginning. */
  async enter(program: string): Promise<void> {
    await this.launch(program, { stopOnEntry: true });
    await this.client.configurationDoneRequest();
    await this.stopped();
  }

  /** Begins the run and gives its first stop. */
  async run(): Promise<Stopped> {
    await this.client.configurationDoneRequest();
    return this.stopped();
  }

  /** Any request of the protocol; one that fails throws its message. */
  async request<Body>(command: string, args: unknown = {}): Promise<Body> {
    return ((await this.client.send(command, args)) as { body: Body }).body;
  }

  /** Moves thread `thread` of the card and gives where everything stands. */
  async move(command: string, thread = 0, args: object = {}): Promise<Stopped> {
    await this.request(command, { threadId: thread + 1, ...args });
    return this.stopped();
  }

  async console(expression: string): Promise<string> {
    const args = { expression, context: "repl", frameId: 1 };
    return (await this.request<{ result: string }>("evaluate", args)).result;
  }

  async value(expression: string, frameId?: number): Promise<string> {
    const args = { expression, context: "watch", frameId };
    return (await this.request<{ result: string }>("evaluate", args)).result;
  }

  /** The line at which a thread stands. */
  async line(thread = 0): Promise<number | undefined> {
    return (await this.frame(thread)).line;
  }

  /** True if a thread can execute a statement: it can be moved where it stands. */
  async ready(thread: number): Promise<boolean> {
    const { name, path } = (await this.frame(thread)).source ?? {};
    const args = { source: { name, path }, line: await this.line(thread) };
    const { targets } = await this.request<{ targets: { id: number }[] }>("gotoTargets", args);
    return targets.some(({ id }) => id === thread);
  }

  async frame(thread = 0): Promise<DebugProtocol.StackFrame> {
    const { stackFrames } = await this.request<{ stackFrames: DebugProtocol.StackFrame[] }>(
      "stackTrace",
      { threadId: thread + 1 },
    );
    return only(stackFrames);
  }

  async scope(name: string, thread = 0): Promise<number> {
    const { scopes } = await this.request<{ scopes: DebugProtocol.Scope[] }>("scopes", {
      frameId: thread + 1,
    });
    return only(scopes.filter((scope) => scope.name === name)).variablesReference;
  }

  async variables(variablesReference: number): Promise<DebugProtocol.Variable[]> {
    const args = { variablesReference };
    return (await this.request<{ variables: DebugProtocol.Variable[] }>("variables", args))
      .variables;
  }

  /** Sets the breakpoints of a file. */
  async breakpoints(
    path: string,
    breakpoints: DebugProtocol.SourceBreakpoint[],
  ): Promise<DebugProtocol.Breakpoint[]> {
    const args = { source: { path }, breakpoints };
    return (await this.request<{ breakpoints: DebugProtocol.Breakpoint[] }>("setBreakpoints", args))
      .breakpoints;
  }
}

/** An adapter that ends with the test. */
export async function openEditor(
  environment: Record<string, string | undefined> = { ...process.env, ONCARD: oncard },
): Promise<Editor> {
  const editor = new Editor(environment);
  onTestFinished(() => editor.client.stop());
  await editor.client.start();
  return editor;
}

/** The one element of a list. */
export function only<T>(list: readonly T[]): T {
  const [first, ...others] = list;
  if (first === undefined || others.length > 0) throw new Error(`${list.length} elements, not one`);
  return first;
}

/** The element with a name. */
export function named<T extends { name: string }>(list: readonly T[], name: string): T {
  return only(list.filter((each) => each.name === name));
}
