import { cpSync, existsSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { beforeEach, describe, expect, test } from "vitest";

import { Engines, findInPath } from "../src/engines";
import { registerFeatures } from "../src/features";
import {
  type CustomExecution,
  type DebugAdapterExecutable,
  debug,
  documentAt,
  editor,
  env,
  type FakeController,
  ProcessExecution,
  session,
  type Task,
  TestMessage,
  TestRunProfileKind,
  Uri,
  window,
  workspace,
} from "./fake_vscode.js";
import { folder, newFolder, oncard, provider, sample, withoutCommand } from "./support.js";

/** The extension with the command. */
function activate(): void {
  editor.settings["oncard.path"] = oncard;
  registerFeatures(new Engines(folder));
}

function show(path: string, languageId = "c"): void {
  window.activeTextEditor = { document: documentAt(path, languageId) };
}

async function execute(command: string, ...args: unknown[]): Promise<void> {
  await editor.commands.get(command)?.(...args);
}

beforeEach(() => {
  editor.reset();
});

describe("the engine", () => {
  test("is the command of the setting", () => {
    editor.settings["oncard.path"] = "/somewhere/oncard";
    expect(new Engines(folder).command()).toBe("/somewhere/oncard");
  });

  test("or the one in PATH", () => {
    expect(findInPath({ PATH: `/nowhere:${join(oncard, "..")}` }, "linux")).toBe(oncard);
    expect(findInPath({ PATH: "/nowhere::" }, "linux")).toBeUndefined();
    expect(findInPath({}, "linux")).toBeUndefined();
  });

  test("or the module, if there is no command", () => {
    withoutCommand();
    expect(new Engines(folder).command()).toBeUndefined();
  });
});

describe("debugging", () => {
  const descriptor = () =>
    provider<{ createDebugAdapterDescriptor(): DebugAdapterExecutable }>(
      "adapter",
    ).createDebugAdapterDescriptor();
  const resolve = (config: object) =>
    provider<{ resolveDebugConfiguration(folder: unknown, config: object): unknown }>(
      "launch",
    ).resolveDebugConfiguration(undefined, { type: "", name: "", request: "", ...config });

  test("uses the command, or the module without one", () => {
    activate();
    expect(descriptor().options.env).toEqual({ ONCARD: oncard });
    editor.settings["oncard.path"] = "";
    withoutCommand();
    const { command, args, options } = descriptor();
    expect(command).toBe("node");
    expect(args).toEqual([join(folder, "dist/adapter.js")]);
    expect(options.env).toEqual({ ONCARD_MODULE: join(folder, "dist/oncard.wasm") });
  });

  test("without a configuration begins with the open file", () => {
    activate();
    show(sample("01_sum/two_threads.toml"), "toml");
    expect(resolve({})).toMatchObject({
      type: "oncard",
      request: "launch",
      program: sample("01_sum/two_threads.toml"),
      stopOnEntry: true,
    });
    const config = { type: "oncard", request: "launch", name: "a", program: "/p.c" };
    expect(resolve(config)).toEqual(config);
  });

  test("without an open file says what to do", () => {
    activate();
    env.language = "zh-cn";
    expect(resolve({})).toBeUndefined();
    expect(editor.shown).toEqual(["请先打开程序、场景或记录"]);
  });

  test("lets a thread of the call stack, or one that is picked, go next", async () => {
    activate();
    debug.activeDebugSession = session;
    const threads = [
      { id: 1, name: "0 add" },
      { id: 2, name: "1 add" },
    ];
    editor.debugAnswers = { threads: { threads }, evaluate: { result: "" } };
    await execute("oncard.runThreadNext", { threadId: 2 });
    const chosen = { command: "evaluate", args: { expression: "thread 1", context: "repl" } };
    expect(editor.requests).toEqual(["threads", chosen]);
    editor.answers = [{ id: 1 }];
    await execute("oncard.runThreadNext");
    expect(editor.shown).toEqual(["0 add,1 add"]);
    expect(editor.requests.at(-1)).toMatchObject({ args: { expression: "thread 0" } });
  });

  test("saves the schedule under a name, and says why not", async () => {
    activate();
    debug.activeDebugSession = session;
    editor.answers = ["a.schedule", undefined, "../b", undefined, undefined];
    editor.debugAnswers = { evaluate: { result: "/a/b.schedule" } };
    await execute("oncard.saveSchedule");
    expect(editor.shown.at(-1)).toBe("saved /a/b.schedule");
    editor.debugAnswers = { evaluate: new Error("a name without a folder") };
    await execute("oncard.saveSchedule");
    expect(editor.shown.at(-1)).toBe("a name without a folder");
    const asked = editor.requests.length;
    await execute("oncard.saveSchedule");
    expect(editor.requests).toHaveLength(asked);
  });
});

describe("commands", () => {
  test("run shows the values", async () => {
    activate();
    show(sample("01_sum/two_threads.toml"), "toml");
    await execute("oncard.run");
    expect(editor.shown).toContain("passed");
  });

  test("run says which case it takes of what is left open", async () => {
    activate();
    const program = join(newFolder(), "p.c");
    writeFileSync(program, "int n;\n//@ input: n = 3..9\nint t0()\n{\n  return n;\n}\n");
    await execute("oncard.run", Uri.file(program));
    expect(editor.shown).toContain("choice: n = 3");
  });

  test("a program runs with the scenario that names it", async () => {
    activate();
    await execute("oncard.debug", Uri.file(sample("26_lost_update/sum.c")));
    expect(editor.launched).toMatchObject([{ program: sample("26_lost_update/bounds.toml") }]);
  });

  test("the listing shows what each line becomes", async () => {
    activate();
    show(sample("01_sum/sum.c"));
    await execute("oncard.showListing");
    const uri = Uri.parse(editor.shown.at(-1) ?? "");
    const text = await provider<{ provideTextDocumentContent(uri: unknown): Promise<string> }>(
      "oncard-listing",
    ).provideTextDocumentContent(uri);
    await expect(text).toMatchFileSnapshot("listing.txt");
  });
});

describe("tasks", () => {
  interface Provider {
    provideTasks(): Promise<Task[]>;
    resolveTask(task: Pick<Task, "definition">): Task;
  }

  test("of a program and of a scenario", async () => {
    activate();
    const names = async () => {
      const tasks = await provider<Provider>("tasks").provideTasks();
      return tasks.map(({ name }) => name);
    };
    expect(await names()).toEqual([]);
    show(sample("01_sum/sum.c"));
    const ofProgram = ["build sum.c", "check sum.c", "run sum.c", "explore sum.c"];
    expect(await names()).toEqual(ofProgram);
    show(sample("01_sum/one_thread.toml"), "toml");
    expect(await names()).toEqual(
      ["run", "explore", "test"].map((each) => `${each} one_thread.toml`),
    );
  });

  test("run the command", () => {
    activate();
    const definition = { type: "oncard", command: "check", file: "${workspaceFolder}/p.c" };
    const { execution, definition: kept } = provider<Provider>("tasks").resolveTask({ definition });
    expect(execution).toEqual(
      new ProcessExecution(oncard, ["--lang=en", "check", "${workspaceFolder}/p.c"]),
    );
    expect(kept).toBe(definition);
  });

  test("that need the command say so", async () => {
    activate();
    editor.settings["oncard.path"] = "";
    withoutCommand();
    const definition = { type: "oncard", command: "build", file: "p.c" };
    const { execution } = provider<Provider>("tasks").resolveTask({ definition });
    const terminal = (await (execution as CustomExecution).callback()) as {
      onDidWrite(listener: (text: string) => void): void;
      onDidClose(listener: (code: number) => void): void;
      open(): void;
    };
    let written = "";
    terminal.onDidWrite((text) => (written += text));
    const code = await new Promise((resolve) => {
      terminal.onDidClose(resolve);
      terminal.open();
    });
    expect({ code, written }).toEqual({
      code: 2,
      written: "building .bin and .ini files needs the oncard command: set oncard.path\r\n",
    });
  });
});

describe("lenses", () => {
  interface Lens {
    range: { start: { line: number } };
    command?: { title: string; command: string; arguments?: unknown[] };
  }
  const lensesOf = (document: unknown) =>
    provider<{ provideCodeLenses(document: unknown): Promise<Lens[]> }>("lenses").provideCodeLenses(
      document,
    );
  const titles = async (path: string, languageId = "c") => {
    const lenses = await lensesOf(documentAt(path, languageId));
    return lenses.map(({ command }) => command?.title);
  };

  test("stand above programs and scenarios, in the language of the editor", async () => {
    activate();
    const above = ["run", "debug", "explore"];
    expect((await titles(sample("01_sum/sum.c"))).slice(0, 3)).toEqual(above);
    env.language = "zh-cn";
    const path = sample("01_sum/one_thread.toml");
    expect(await titles(path, "toml")).toEqual(["运行", "调试", "探索"]);
  });

  test("stand above each function with which a thread can begin, where it is defined", async () => {
    activate();
    const path = join(newFolder(), "p.c");
    const helper = "int twice(int x);\nint twice(int x)\n{\n  return 2 * x;\n}\n";
    const threads = "int f()\n{\n  return twice(1);\n}\n\nvoid g()\n{\n}\n";
    writeFileSync(path, `//@ structured\n${helper}${threads}`);
    const document = documentAt(path);
    const lenses = (await lensesOf(document)).slice(3);
    expect(lenses).toMatchObject([
      { range: { start: { line: 6 } }, command: { title: "debug f" } },
      { range: { start: { line: 11 } }, command: { title: "debug g" } },
    ]);
    env.language = "zh-cn";
    expect((await lensesOf(document)).at(-1)).toMatchObject({ command: { title: "调试 g" } });
    const { command } = lenses[1] ?? {};
    await execute(command?.command ?? "", ...(command?.arguments ?? []));
    expect(editor.launched).toEqual([
      { type: "oncard", request: "launch", name: "oncard", program: path, stopAtFunction: "g" },
    ]);
  });

  test("debug a function with the scenario of its program", async () => {
    activate();
    const [, , , lens] = await lensesOf(documentAt(sample("01_sum/sum.c")));
    await execute("oncard.debug", ...(lens?.command?.arguments ?? []));
    // The first one by name.
    const program = sample("01_sum/one_after_the_other.toml");
    expect(editor.launched).toMatchObject([{ program, stopAtFunction: "add" }]);
  });

  test("of functions are missing if there is no engine", async () => {
    activate();
    editor.settings["oncard.path"] = "/nowhere/oncard";
    expect(await titles(sample("01_sum/sum.c"))).toEqual(["run", "debug", "explore"]);
    editor.settings["oncard.path"] = oncard;
    expect(await titles(sample("01_sum/sum.c"))).toHaveLength(4);
  });

  test("but not above hosts, or if they are not wanted", async () => {
    activate();
    expect(await titles(sample("22_homing/host.c"))).toEqual([]);
    editor.settings["oncard.codeLens"] = false;
    expect(await titles(sample("01_sum/sum.c"))).toEqual([]);
  });
});

describe("inline values", () => {
  const valuesIn = (document: unknown) =>
    provider<{ provideInlineValues(document: unknown): Promise<unknown[]> }>(
      "inline values",
    ).provideInlineValues(document);
  const path = sample("01_sum/sum.c");
  const line = { thread: 0, file: "sum.c", path, line: 17, moment: 4 };
  const values = [{ name: "sum", value: 3 }];

  test("say what the lines of the document have made, and of several threads which one", async () => {
    activate();
    debug.activeDebugSession = session;
    const other = { ...line, values, path: sample("02_loops/other.c") };
    editor.debugAnswers["oncard.written"] = { lines: [{ ...line, values }, other], moment: 5 };
    const [value, ...more] = await valuesIn(documentAt(path));
    expect(value).toMatchObject({ text: "sum = 3", range: { start: { line: 16, character: 0 } } });
    expect(more).toEqual([]);
    const two = [0, 1].map((thread) => ({ ...line, thread, values }));
    editor.debugAnswers["oncard.written"] = { lines: two, moment: 5 };
    expect(await valuesIn(documentAt(path))).toMatchObject([
      { text: "0: sum = 3" },
      { text: "1: sum = 3" },
    ]);
  });

  test("are not there without this debugger", async () => {
    activate();
    expect(await valuesIn(documentAt(path))).toEqual([]);
    debug.activeDebugSession = { ...session, type: "cppdbg" };
    expect(await valuesIn(documentAt(path))).toEqual([]);
    expect(editor.requests).toEqual([]);
  });
});

describe("the test explorer", () => {
  async function run(...paths: string[]): Promise<FakeController["results"]> {
    activate();
    workspace.files = paths.map((path) => Uri.file(path));
    const [controller] = editor.controllers;
    await controller?.resolveHandler();
    const token = { isCancellationRequested: false, onCancellationRequested: () => undefined };
    await controller?.profiles.get(TestRunProfileKind.Run)?.({}, token);
    return controller?.results ?? {};
  }

  test("runs every scenario, and no other TOML file", async () => {
    const other = sample("22_homing/homing.host.toml");
    expect(existsSync(other)).toBe(true);
    const scenario = sample("01_sum/two_threads.toml");
    expect(await run(scenario, other)).toEqual({ "two_threads.toml": "passed" });
  });

  test("shows what does not hold at its line", async () => {
    const copy = newFolder();
    cpSync(sample("01_sum"), copy, { recursive: true });
    const path = join(copy, "wrong.toml");
    writeFileSync(
      path,
      'program = "sum.c"\nexpect = [\n  "sum == 1",\n]\n[[thread]]\nfunction = "add"\n',
    );
    const { "wrong.toml": messages } = await run(path);
    const [first] = messages as TestMessage[];
    expect(first?.message).toBe("sum == 1: sum is 0");
    expect(first?.location).toMatchObject({ range: { start: { line: 2 } } });
  });

  test("says which case of a scenario does not hold", async () => {
    const copy = newFolder();
    writeFileSync(join(copy, "p.c"), "int n;\nint f()\n{\n  return n;\n}\n");
    writeFileSync(
      join(copy, "a.toml"),
      'program = "p.c"\nglobals = { n = { any = [3, 9] } }\nexpect = ["ret0 == 4"]\n',
    );
    const { "a.toml": messages } = await run(join(copy, "a.toml"));
    const [first] = messages as TestMessage[];
    expect(first?.message).toBe("ret0 == 4: thread0.result is 3\nchoice: n = 3");
  });

  test("shows mistakes of the scenario and of the program at their places", async () => {
    const copy = newFolder();
    writeFileSync(join(copy, "a.toml"), 'program = "p.c"\nexpec = []\n');
    writeFileSync(join(copy, "b.toml"), 'program = "p.c"\n');
    writeFileSync(join(copy, "p.c"), "int f()\n{\n  x = 1;\n}\n");
    const results = await run(join(copy, "a.toml"), join(copy, "b.toml"));
    const place = (name: string) => (results[name] as TestMessage[])[0]?.location;
    expect(place("a.toml")).toMatchObject({ range: { start: { line: 1 } } });
    expect(place("b.toml")).toMatchObject({
      uri: { path: join(copy, "p.c") },
      range: { start: { line: 2 } },
    });
  });
});
