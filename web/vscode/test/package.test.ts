// The package: what is in it, and that it needs nothing else, as on a computer without the command.

import { spawn } from "node:child_process";
import { EventEmitter } from "node:events";
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { createRequire, Module } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";

import { DebugClient } from "@vscode/debugadapter-testsupport";
import type { DebugProtocol } from "@vscode/debugprotocol";
import {
  afterAll,
  beforeAll,
  beforeEach,
  describe,
  expect,
  onTestFinished,
  test,
  vi,
} from "vitest";
import type { PublishDiagnosticsParams } from "vscode-languageserver";
import {
  createMessageConnection,
  StreamMessageReader,
  StreamMessageWriter,
} from "vscode-languageserver/node.js";

import { Engines } from "../src/engines";
import { registerFeatures } from "../src/features";
import type { ToView as ToFailingRun } from "../src/failing_run_messages";
import type { ToView as ToMachine } from "../src/machine_messages";
import type { ToView } from "../src/two_columns_messages";
import {
  type CustomExecution,
  documentAt,
  editor,
  Range,
  session,
  type Task,
  type TestMessage,
  TestRunProfileKind,
  Uri,
  window,
  workspace,
} from "./fake_vscode.js";
import {
  filesIn,
  newFolder,
  packed,
  provider,
  sample,
  withoutCommand,
  withoutModule,
} from "./support.js";

interface Tracker {
  onDidSendMessage(message: object): void;
  onWillStopSession(): void;
}

describe.skipIf(withoutModule)("the package", () => {
  let work = "";
  let files: Record<string, Uint8Array> = {};
  /** The folder of the installed extension. */
  let installed = "";

  beforeAll(() => {
    work = mkdtempSync(join(tmpdir(), "oncard-"));
    files = filesIn(packed(work));
    installed = join(work, "installed", "extension");
    for (const [name, bytes] of Object.entries(files)) {
      const path = join(work, "installed", name);
      mkdirSync(dirname(path), { recursive: true });
      writeFileSync(path, bytes);
    }
  }, 60_000); // packing takes 5 s, on a busy computer more than the usual 10
  afterAll(() => {
    rmSync(work, { recursive: true, force: true });
  });
  beforeEach(() => {
    editor.reset();
    withoutCommand();
  });

  const textIn = (name: string) => new TextDecoder().decode(files[name]);

  /** A copy of a sample that may be written to. */
  function copyOf(name: string): string {
    const folder = newFolder();
    cpSync(sample(name), folder, { recursive: true });
    return folder;
  }

  test("contains what it needs and nothing else", async () => {
    await expect(`${Object.keys(files).join("\n")}\n`).toMatchFileSnapshot("files.txt");
  });

  test("every path of the manifest is inside", () => {
    const paths = [...textIn("extension/package.json").matchAll(/"\.\/([^"]+)"/g)];
    expect(paths.length).toBeGreaterThan(5);
    for (const [, path] of paths) expect(files).toHaveProperty([`extension/${path ?? ""}`]);
  });

  test("the same tree gives the same bytes", () => {
    const again = packed(newFolder());
    expect(readFileSync(again).equals(readFileSync(join(work, "oncard.vsix")))).toBe(true);
  });

  test("has the licences of what it contains", () => {
    const notices = textIn("extension/ThirdPartyNotices.txt");
    for (const name of ["vscode-languageclient", "@vscode/debugadapter", "preact", "wasi-libc"]) {
      expect(notices).toMatch(new RegExp(`^${name} `, "m"));
    }
    expect(textIn("extension/LICENSE.txt")).toContain("MIT");
  });

  test("the extension can be loaded, and needs only what the editor has", () => {
    // Classes that the client extends are those of the editor.
    const anything: unknown = new Proxy(
      {},
      { get: (_, name) => (name === "__esModule" ? false : EventEmitter) },
    );
    const loader = Module as unknown as { _load: (name: string, ...rest: unknown[]) => unknown };
    const load = loader._load;
    onTestFinished(() => {
      loader._load = load;
    });
    loader._load = (name, ...rest) => (name === "vscode" ? anything : load(name, ...rest));
    const extension = createRequire(import.meta.url)(
      join(installed, "dist/extension.js"),
    ) as object;
    expect(extension).toHaveProperty("activate");
  });

  test("the language server shows mistakes", async () => {
    const folder = newFolder();
    writeFileSync(join(folder, "s.toml"), 'program = "p.c"\n');
    const uri = pathToFileURL(join(folder, "p.c")).href;
    const server = spawn(process.execPath, [join(installed, "dist/server.js"), "--stdio"], {
      env: {},
    });
    const wire = createMessageConnection(
      new StreamMessageReader(server.stdout),
      new StreamMessageWriter(server.stdin),
    );
    onTestFinished(() => {
      wire.dispose();
      server.kill();
    });
    const found = new Promise<PublishDiagnosticsParams>((resolve) => {
      wire.onNotification("textDocument/publishDiagnostics", resolve);
    });
    wire.listen();
    await wire.sendRequest("initialize", { processId: null, rootUri: null, capabilities: {} });
    await wire.sendNotification("initialized", {});
    const textDocument = { uri, languageId: "c", version: 1, text: "int f()\n{\n  x = 1;\n}\n" };
    await wire.sendNotification("textDocument/didOpen", { textDocument });
    expect(await found).toMatchObject({ uri, diagnostics: [{ code: "MP027" }] });
  });

  test("a program is stepped forward and back", async () => {
    registerFeatures(new Engines(installed));
    const { args, options } = provider<{
      createDebugAdapterDescriptor(): { args: string[]; options: { env: Record<string, string> } };
    }>("adapter").createDebugAdapterDescriptor();
    const client = new DebugClient(process.execPath, args[0] ?? "", "oncard", { env: options.env });
    onTestFinished(() => client.stop());
    await client.start();
    await client.initializeRequest({ adapterID: "oncard", pathFormat: "path" });
    const initialized = client.waitForEvent("initialized");
    const config = { program: sample("01_sum/two_threads.toml"), stopOnEntry: true };
    await client.launchRequest(config as DebugProtocol.LaunchRequestArguments);
    await initialized;
    const stopped = client.waitForEvent("stopped");
    await client.configurationDoneRequest();
    await stopped;
    const lines: number[] = [];
    for (const command of ["next", "next", "stepBack"]) {
      const moved = client.waitForEvent("stopped");
      await client.send(command, { threadId: 1 });
      await moved;
      const { body } = await client.stackTraceRequest({ threadId: 1 });
      lines.push(body.stackFrames[0]?.line ?? 0);
    }
    expect(lines[2]).toBe(lines[0]);
    expect(lines[1]).toBeGreaterThan(lines[0] ?? 0);
  });

  test("C stands beside card code, and follows the program in the editor", async () => {
    registerFeatures(new Engines(installed));
    const folder = newFolder();
    const path = join(folder, "p.c");
    writeFileSync(path, "//@ structured\nint x;\nint f()\n{\n  ++x;\n}\n");
    let text = readFileSync(path, "utf8");
    const document = { ...documentAt(path), getText: () => text };
    workspace.textDocuments = [document];
    const textEditor = { document, viewColumn: 1, selection: { active: { line: 0 } } };
    window.activeTextEditor = textEditor;
    await editor.commands.get("oncard.showTwoColumns")?.();
    const [panel] = editor.panels;
    if (!panel) throw new Error("there is no panel");
    onTestFinished(() => {
      panel.dispose();
    });
    const shown = () => {
      const last = (panel.sent as ToView[]).filter((each) => each.shown).at(-1)?.shown;
      return [last?.state, last?.rows.find(({ line }) => line === 5)?.card];
    };
    const answer = { timeout: 20_000 };
    await vi.waitFor(() => {
      expect(shown()).toEqual(["fresh", "  x = x + 1;"]);
    }, answer);
    expect(panel.title).toBe("p.c beside card code");

    text = text.replace("++x;", "++x");
    workspace.changed.fire({ document });
    await vi.waitFor(() => {
      expect(shown()).toEqual(["broken", "  x = x + 1;"]);
    }, answer);
    text = text.replace("++x", "--x;");
    workspace.changed.fire({ document });
    await vi.waitFor(() => {
      expect(shown()).toEqual(["fresh", "  x = x - 1;"]);
    }, answer);

    textEditor.selection.active.line = 4;
    window.selected.fire({ textEditor });
    expect(panel.sent.at(-1)).toEqual({ chosen: { file: path, line: 5 } });

    // A scenario leaves it as it is; a second wish opens no second panel.
    const scenario = documentAt(sample("01_sum/two_threads.toml"), "toml");
    window.followed.fire({ document: scenario });
    window.followed.fire(undefined);
    await editor.commands.get("oncard.showTwoColumns")?.();
    expect([editor.panels.length, panel.title]).toEqual([1, "p.c beside card code"]);
    window.followed.fire({ ...textEditor, document: documentAt(sample("01_sum/sum.c")) });
    await vi.waitFor(() => {
      expect(shown()).toEqual(["plain", undefined]);
    }, answer);
    expect(panel.title).toBe("sum.c beside card code");

    // The page of the panel comes again, and its reader wants to see a line.
    panel.received.fire("ready");
    expect(panel.sent.at(-1)).toMatchObject({
      shown: { state: "plain" },
      language: "en",
      chosen: { file: sample("01_sum/sum.c"), line: 5 },
    });
    panel.received.fire({ show: { file: path, line: 5 } });
    await vi.waitFor(() => {
      expect(editor.shown.slice(-2)).toEqual([
        Uri.file(path).toString(),
        JSON.stringify({ line: 4, character: 0 }),
      ]);
    });

    // The pointer is at what a line became, and then no longer.
    const marked = vi.fn();
    window.visibleTextEditors = [{ ...textEditor, setDecorations: marked }];
    panel.received.fire({ point: { file: path, line: 5 } });
    expect(marked).toHaveBeenLastCalledWith(expect.anything(), [new Range(4, 0, 4, 0)]);
    panel.received.fire({ point: { file: sample("01_sum/sum.c"), line: 5 } });
    expect(marked).toHaveBeenLastCalledWith(expect.anything(), []);
    panel.received.fire({ point: null });
    expect(marked).toHaveBeenCalledTimes(3);
    panel.dispose();
    await editor.commands.get("oncard.showTwoColumns")?.();
    expect(editor.panels).toHaveLength(2);
    editor.panels[1]?.dispose();
  });

  test("a panel may load what is in the package alone", () => {
    registerFeatures(new Engines(installed));
    void editor.commands.get("oncard.showTwoColumns")?.();
    const [panel] = editor.panels;
    const { html } = panel?.webview ?? { html: "" };
    panel?.dispose();
    expect(html).toContain(
      "default-src 'none'; script-src https://editor; style-src https://editor",
    );
    const loaded = [...html.matchAll(/(?:src|href)="https:\/\/editor([^"]+)"/g)];
    expect(loaded).toHaveLength(2);
    for (const [, path] of loaded) expect(existsSync(path ?? "")).toBe(true);
  });

  test("a counterexample of an exploration is opened in the debugger", async () => {
    const folder = copyOf("26_lost_update");
    registerFeatures(new Engines(installed));
    editor.answers = ["Step through it"];
    await editor.commands.get("oncard.explore")?.(Uri.file(join(folder, "lost.toml")));
    expect(editor.shown.join("\n")).toMatch(/thread 0 wrote sum = 1 over thread 1's 7/);
    expect(editor.shown.at(-1)).toBe("there is an interleaving that fails");
    const program = join(folder, "lost.schedule");
    expect(editor.launched).toMatchObject([{ type: "oncard", program }]);
    expect(readFileSync(program, "utf8")).toMatch(/^run 0 4\nnext 16 1 sum = copy \+ i;$/m);
  });

  test("a failing run leads into the debugger, and follows it", async () => {
    const folder = copyOf("26_lost_update");
    registerFeatures(new Engines(installed));
    await editor.commands.get("oncard.explore")?.(Uri.file(join(folder, "lost.toml")));
    const [panel] = editor.panels;
    if (!panel) throw new Error("there is no panel");
    onTestFinished(() => {
      panel.dispose();
    });
    expect(panel.title).toBe("lost.toml: failing run");
    panel.received.fire("ready");
    const sent = panel.sent as ToFailingRun[];
    expect(sent.at(-1)).toMatchObject({
      run: { actual: "sum is 3, expected 10" },
      language: "en",
      now: null,
    });

    panel.received.fire({ step: 3 });
    const program = join(folder, "lost.schedule");
    await vi.waitFor(() => {
      expect(editor.launched).toMatchObject([{ type: "oncard", program, stopAtStatement: 3 }]);
    });
    const tracked = (configuration: object) => {
      const tracker = provider<{ createDebugAdapterTracker(session: object): Tracker }>("tracker");
      return tracker.createDebugAdapterTracker({ ...session, configuration });
    };
    const stopped = { type: "event", event: "stopped" };
    const [other, own] = [tracked({ program: "other.c" }), tracked({ program })];
    editor.debugAnswers["evaluate"] = { result: "3" };
    other.onDidSendMessage(stopped);
    own.onDidSendMessage(stopped);
    await vi.waitFor(() => {
      expect(sent.at(-1)).toEqual({ now: 3 });
    });
    const inConsole = (expression: string) => ({
      command: "evaluate",
      args: { expression, context: "repl" },
    });
    panel.received.fire({ step: 7 });
    await vi.waitFor(() => {
      expect(editor.requests).toEqual([inConsole("statement"), inConsole("statement 7")]);
    });
    own.onWillStopSession();
    expect(sent.at(-1)).toEqual({ now: null });

    // Its schedule cannot be kept.
    rmSync(program);
    mkdirSync(program);
    panel.received.fire({ step: 3 });
    await vi.waitFor(() => {
      expect(editor.shown.at(-1)).toMatch(/^EISDIR: /);
    });
  });

  test("the machine follows the debugger, and its inputs can be switched", async () => {
    registerFeatures(new Engines(installed));
    await editor.commands.get("oncard.showMachine")?.();
    const [panel] = editor.panels;
    if (!panel) throw new Error("there is no panel");
    onTestFinished(() => {
      panel.dispose();
    });
    panel.received.fire("ready");
    const sent = panel.sent as ToMachine[];
    expect(sent.at(-1)).toMatchObject({
      machine: null,
      idle: "Debug a program: its axes are shown here.",
    });

    const tracker = provider<{ createDebugAdapterTracker(session: object): Tracker }>("tracker");
    const own = tracker.createDebugAdapterTracker(session);
    const axis = (number: number, value: number) => ({
      part: "axis",
      number,
      values: [{ name: "prfPos", path: `axis${number}.prfPos`, value, unit: "pulse" }],
    });
    const stands = (x: number, y: number, time_ms: number) => {
      const parts = [axis(1, x), axis(2, y)];
      const card = { parts, words: [], switches: [], paths: [], view: { kind: "auto" } };
      editor.debugAnswers["oncard.card"] = { card, state: { head: time_ms, time_ms } };
      own.onDidSendMessage({ type: "event", event: "stopped" });
    };
    stands(0, 0, 0);
    await vi.waitFor(() => {
      expect(sent.at(-1)).toMatchObject({ machine: { seen: { used: [] }, way: [] } });
    });
    editor.debugAnswers["oncard.trace"] = {
      channels: [
        { name: "axis1.prfPos", least: [0, 10], largest: [10, 20] },
        { name: "axis2.prfPos", least: [0, 5], largest: [5, 5] },
      ],
    };
    stands(20, 5, 7);
    await vi.waitFor(() => {
      expect(sent.at(-1)).toMatchObject({
        machine: {
          seen: { used: [1, 2] },
          way: [
            [10, 5],
            [20, 5],
          ],
        },
      });
    });
    expect(editor.requests.at(-1)).toEqual({
      command: "oncard.trace",
      args: { names: ["axis1.prfPos", "axis2.prfPos"], from_ms: 0, to_ms: 7, points: 300 },
    });

    const input = { type: "gpi", index: 3, level: 1 };
    panel.received.fire({ word: "gpi", pin: 3, level: 1 });
    expect(editor.requests.at(-1)).toEqual({ command: "oncard.setInput", args: input });
    editor.debugAnswers["oncard.setInput"] = new Error("a switch is wired to it");
    panel.received.fire({ word: "gpi", pin: 3, level: 1 });
    await vi.waitFor(() => {
      expect(editor.shown.at(-1)).toBe("a switch is wired to it");
    });

    own.onWillStopSession();
    expect(sent.at(-1)).toMatchObject({ machine: null });
  });

  // As `oncard test`: lost.toml expects FAILED, and the run by turns gives the right sum.
  test("the test explorer explores the scenarios that say so", async () => {
    const folder = copyOf("26_lost_update");
    const scenario = join(folder, "lost.toml");
    const proved = join(folder, "proved.toml");
    const text = readFileSync(scenario, "utf8");
    writeFileSync(proved, text.replace(/^explore.*$/m, 'explore = "prove"'));
    workspace.files = [scenario, proved].map((path) => Uri.file(path));
    registerFeatures(new Engines(installed));
    const [controller] = editor.controllers;
    await controller?.resolveHandler();
    const token = { isCancellationRequested: false, onCancellationRequested: () => undefined };
    await controller?.profiles.get(TestRunProfileKind.Run)?.({}, token);
    const { "lost.toml": first, "proved.toml": second } = controller?.results ?? {};
    expect(first).toBe("passed");
    const [message] = second as TestMessage[];
    expect(message?.message).toMatch(/^the verdict should be PROVED:\nFAILED\n/);
    expect(message?.location).toMatchObject({ range: { start: { line: 3 } } });
  });

  test.each([
    ["explore", "26_lost_update", "lost.toml", 1, /does not hold/],
    ["check", "01_sum", "sum.c", 0, /^$/],
    ["run", "01_sum", "two_threads.toml", 0, /sum = 5050\r\npassed/],
    ["test", "01_sum", "nothing.toml", 1, /cannot|no file/],
  ])("the task %s works with the module: %s/%s", async (command, name, file, exitCode, text) => {
    registerFeatures(new Engines(installed));
    const definition = { type: "oncard", command, file: join(copyOf(name), file) };
    const { execution } = provider<{ resolveTask(task: object): Task }>("tasks").resolveTask({
      definition,
    });
    const terminal = (await (execution as CustomExecution).callback()) as {
      onDidWrite(listener: (text: string) => void): void;
      onDidClose(listener: (code: number) => void): void;
      open(): void;
    };
    let written = "";
    terminal.onDidWrite((each) => (written += each));
    const code = await new Promise((resolve) => {
      terminal.onDidClose(resolve);
      terminal.open();
    });
    expect(written).toMatch(text);
    expect(code).toBe(exitCode);
  });
});
