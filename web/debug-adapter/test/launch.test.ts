import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";

import { describe, expect, test } from "vitest";

import { folderOf, oncard, openEditor, programOf, sample, wasm, withoutModule } from "./support.js";

const program = "int x;\nint f()\n{\n  x = 1;\n  return x;\n}\n";
const endless = "int x;\nint f()\n{\nagain:\n  x = x + 1;\n  goto again;\n}\n";

test("the capabilities are those with tests", async () => {
  const editor = await openEditor();
  const capabilities = await editor.initialize();
  // Where each of them is tested.
  const tested = {
    breakpoints: [
      "exceptionBreakpointFilters",
      "supportsConditionalBreakpoints",
      "supportsDataBreakpoints",
      "supportsExceptionInfoRequest",
      "supportsFunctionBreakpoints",
      "supportsHitConditionalBreakpoints",
      "supportsInstructionBreakpoints",
      "supportsLogPoints",
    ],
    launch: ["supportsConfigurationDoneRequest", "supportsTerminateRequest"],
    code: [
      "supportsDisassembleRequest",
      "supportsLoadedSourcesRequest",
      "supportsReadMemoryRequest",
    ],
    moving: ["supportsGotoTargetsRequest", "supportsStepBack", "supportsSteppingGranularity"],
    restart: ["supportsRestartRequest"],
    completions: ["supportsCompletionsRequest", "completionTriggerCharacters"],
    variables: ["supportsEvaluateForHovers", "supportsSetExpression", "supportsSetVariable"],
  };
  expect(Object.keys(capabilities).sort()).toEqual(Object.values(tested).flat().sort());
});

test("the case of a scenario with choices is said", async () => {
  const scenario = 'program = "p.c"\nglobals = { x = { any = [3, 5] } }\n';
  const folder = folderOf({ "p.c": program, "s.toml": scenario });
  const editor = await openEditor();
  await editor.launch(join(folder, "s.toml"));
  expect(editor.output).toContain("choice: x = 3\n");
});

describe("where oncard is looked for", () => {
  test("first in the launch configuration", async () => {
    const editor = await openEditor({ ...process.env, ONCARD: "/nowhere/oncard" });
    await editor.launch(programOf(program), { oncard });
  });

  test("then in the environment", async () => {
    const editor = await openEditor({ ...process.env, ONCARD: oncard, PATH: process.env["PATH"] });
    await editor.launch(programOf(program));
  });

  test("then in PATH", async () => {
    const folders = `${dirname(oncard)}:${process.env["PATH"] ?? ""}`;
    const editor = await openEditor({ ...process.env, ONCARD: undefined, PATH: folders });
    await editor.launch(programOf(program));
  });
});

describe("a launch that fails says why", () => {
  const bad: [string, Record<string, unknown>, RegExp][] = [
    ["no program", {}, /lacks 'program'/],
    ["a program that is no text", { program: 7 }, /'program'.* must be a text/],
    [
      "a flag that is none",
      { program: "p.c", stopOnEntry: "yes" },
      /'stopOnEntry'.* true or false/,
    ],
    ["no such program", { program: "/nowhere/p.c" }, /cannot open '\/nowhere\/p.c'/],
    ["no such oncard", { program: "p.c", oncard: "/nowhere/x" }, /cannot start '\/nowhere\/x'/],
    [
      "an oncard that ends",
      { program: "p.c", oncard: "false" },
      /'false' has ended with exit code 1/,
    ],
    [
      "something else as oncard",
      { program: "p.c", oncard: "echo" },
      /not an answer of the session/,
    ],
  ];
  test.each(bad)("%s", async (_, config, why) => {
    const editor = await openEditor();
    await editor.initialize();
    await expect(editor.request("launch", config)).rejects.toThrow(why);
  });

  test("errors of the program are shown with their place", async () => {
    const path = programOf("int f()\n{\n  y = 1;\n}\n");
    const editor = await openEditor();
    await expect(editor.launch(path)).rejects.toThrow(`${path} was not compiled: ${path}:3:`);
    expect(editor.output).toMatch(new RegExp(`^${path}:3:\\d+: error: 'y' is not declared`));
  });

  test("in the editor's language", async () => {
    const editor = await openEditor();
    await editor.initialize({ locale: "zh-cn" });
    await expect(editor.request("launch", {})).rejects.toThrow("启动配置缺少“program”");
    const missing = editor.request("launch", { program: "/nowhere/p.c" });
    await expect(missing).rejects.toThrow("无法打开");
  });

  test("and the editor can try again", async () => {
    const editor = await openEditor();
    await expect(editor.launch("/nowhere/p.c")).rejects.toThrow();
    const launched = editor.request("launch", { program: programOf(program) });
    await expect(launched).resolves.not.toThrow();
  });
});

test("nothing works before a launch", async () => {
  const editor = await openEditor();
  await editor.initialize();
  for (const [command, args] of [
    ["continue", { threadId: 1 }],
    ["stackTrace", { threadId: 1 }],
    ["evaluate", { expression: "x" }],
    ["evaluate", { expression: "cycle", context: "repl" }],
    ["configurationDone", {}],
  ] as const) {
    await expect(editor.request(command, args), command).rejects.toThrow(
      "nothing has been launched",
    );
  }
});

test("structured C", async () => {
  const path = programOf("int x;\nint f()\n{\n  while (x < 3) {\n    x = x + 1;\n  }\n}\n");
  const editor = await openEditor();
  await expect(editor.launch(path)).rejects.toThrow("was not compiled");
  await (await openEditor()).launch(path, { structured: true });
});

test("stopOnEntry stands before the first step", async () => {
  const editor = await openEditor();
  await editor.launch(sample("01_sum/two_threads.toml"), { stopOnEntry: true });
  expect(await editor.run()).toMatchObject({
    reason: "entry",
    threadId: 1,
    allThreadsStopped: true,
  });
  expect(await editor.line()).toBe(13);
});

describe("at the end", () => {
  test("the verdict is shown, and one can go back", async () => {
    const editor = await openEditor();
    await editor.launch(sample("01_sum/two_threads.toml"));
    expect(await editor.run()).toMatchObject({ reason: "pause", text: /every thread has ended/ });
    expect(editor.output).toMatch(/^passed$/m);
    await editor.move("stepBack");
    expect(await editor.line()).toBe(21);
  });

  test("what was not fulfilled is shown", async () => {
    const editor = await openEditor();
    await editor.launch(sample("26_lost_update/lost.toml"));
    await editor.run();
    expect(editor.output).toMatch(/^failed\nsum == 10: sum is 7$/m);
  });

  test("a session ends when the user goes on", async () => {
    for (const [scenario, exitCode] of [
      ["01_sum/two_threads.toml", 0],
      ["26_lost_update/lost.toml", 1],
    ] as const) {
      const editor = await openEditor();
      await editor.launch(sample(scenario));
      await editor.run();
      const exited = editor.client.waitForEvent("exited");
      const terminated = editor.client.waitForEvent("terminated");
      await editor.request("continue", { threadId: 1 });
      expect((await exited).body, scenario).toEqual({ exitCode });
      await terminated;
    }
  });

  test("a change in the middle of a cycle counts", async () => {
    const editor = await openEditor();
    await editor.launch(sample("01_sum/two_threads.toml"), { stopOnEntry: true });
    await editor.run();
    await editor.move("stepIn");
    const expression = "sum";
    await editor.request("setExpression", { expression, value: "7" });
    await editor.move("continue");
    expect(editor.output).toMatch(/^failed$/m);
    const exited = editor.client.waitForEvent("exited");
    await editor.request("continue", { threadId: 1 });
    expect((await exited).body).toEqual({ exitCode: 1 });
  });

  test("the user's choices count", async () => {
    const editor = await openEditor();
    await editor.enter(sample("26_lost_update/lost.toml"));
    while (await editor.ready(0)) {
      await editor.console("thread 0");
      await editor.stopped();
    }
    await editor.move("continue");
    expect(editor.output).toMatch(/^passed$/m);
  });
});

describe("stopAtFunction", () => {
  // Thread 0 executes `f`, whose loop comes to the first statement again; thread 1 executes `g`.
  const files = {
    "p.c":
      "int x;\nint f()\n{\n  int c;\nagain:\n  x = x + 1;\n  c = x < 3;\n" +
      "  if (c) goto again;\n}\nint g()\n{\n  GT_Delay(2);\n  x = x + 10;\n}\n",
    "both.toml":
      'program = "p.c"\n[[thread]]\nfunction = "f"\n[[thread]]\nfunction = "g"\nthread = 1\n',
  };

  test("stops before the first statement of the function, once", async () => {
    const editor = await openEditor();
    await editor.launch(join(folderOf(files), "both.toml"), { stopAtFunction: "f" });
    expect(await editor.run()).toMatchObject({ reason: "entry", threadId: 1 });
    expect([await editor.line(), await editor.value("x")]).toEqual([6, "0"]);
    expect(await editor.move("continue")).toMatchObject({ reason: "pause" });
    expect(await editor.value("x")).toBe("13");
  });

  test("stops with the thread that executes it; breakpoints of the user stay", async () => {
    const folder = folderOf(files);
    const editor = await openEditor();
    await editor.launch(join(folder, "both.toml"), { stopAtFunction: "g", stopOnEntry: true });
    const points = [{ line: 8 }, { line: 12 }];
    const [, last] = await editor.breakpoints(join(folder, "p.c"), points);
    expect(await editor.run()).toMatchObject({ reason: "entry", threadId: 1 });
    expect(await editor.move("continue")).toMatchObject({ reason: "entry", threadId: 2 });
    expect(await editor.line(1)).toBe(12);
    await editor.breakpoints(join(folder, "p.c"), points.slice(1));
    await editor.move("reverseContinue");
    expect(await editor.move("continue")).toMatchObject({ reason: "breakpoint", threadId: 2 });
    expect(last).toMatchObject({ verified: true, line: 12 });
  });

  test("again when the program is launched again", async () => {
    const editor = await openEditor();
    await editor.launch(join(folderOf(files), "both.toml"), { stopAtFunction: "g" });
    await editor.run();
    await editor.request("restart");
    expect(await editor.stopped()).toMatchObject({ reason: "entry", threadId: 2 });
  });

  test("not in a run without debugging", async () => {
    const editor = await openEditor();
    const program = join(folderOf(files), "both.toml");
    await editor.launch(program, { stopAtFunction: "f", noDebug: true });
    await Promise.all([
      editor.client.waitForEvent("terminated"),
      editor.client.configurationDoneRequest(),
    ]);
  });

  test("a function that does not exist is an error", async () => {
    const editor = await openEditor();
    const launched = editor.launch(join(folderOf(files), "both.toml"), { stopAtFunction: "h" });
    await expect(launched).rejects.toThrow(
      "'stopAtFunction' of the launch configuration: the program has no function 'h' with statements; it has f, g",
    );
  });
});

describe("stopAtStatement", () => {
  const text = "int x;\nint f()\n{\n  x = 1;\n  x = 2;\n  x = 3;\n}\n";

  test("stands after that statement of the run", async () => {
    const editor = await openEditor();
    await editor.launch(programOf(text), { stopAtStatement: 2 });
    expect(await editor.run()).toMatchObject({ reason: "step", threadId: 1 });
    expect([await editor.line(), await editor.value("x")]).toEqual([6, "2"]);
  });

  test("not in a run without debugging", async () => {
    const editor = await openEditor();
    await editor.launch(programOf(text), { stopAtStatement: 2, noDebug: true });
    await Promise.all([
      editor.client.waitForEvent("terminated"),
      editor.client.configurationDoneRequest(),
    ]);
  });

  test("after stopOnEntry it is left out", async () => {
    const editor = await openEditor();
    await editor.launch(programOf(text), { stopAtStatement: 2, stopOnEntry: true });
    expect(await editor.run()).toMatchObject({ reason: "entry" });
    expect(await editor.move("continue")).toMatchObject({ text: /every thread has ended/ });
  });

  test.each([-1, 1.5, "2"])("%j is no number of a statement", async (stopAtStatement) => {
    const editor = await openEditor();
    await expect(editor.launch(programOf(text), { stopAtStatement })).rejects.toThrow(
      "'stopAtStatement' of the launch configuration must be the number of a statement of the run",
    );
  });
});

test("a run without debugging stops nowhere and ends by itself", async () => {
  const editor = await openEditor();
  const path = sample("05_arrays/out_of_bounds.toml");
  await editor.launch(path, { noDebug: true });
  await editor.breakpoints(sample("05_arrays/largest.c"), [{ line: 35 }]);
  await editor.request("setExceptionBreakpoints", { filters: ["fault"] });
  const exited = editor.client.waitForEvent("exited");
  const terminated = editor.client.waitForEvent("terminated");
  await editor.client.configurationDoneRequest();
  expect((await exited).body).toEqual({ exitCode: 0 });
  await terminated;
});

test("terminate ends a program without an end", async () => {
  const editor = await openEditor();
  await editor.launch(programOf(endless));
  await editor.client.configurationDoneRequest();
  const terminated = editor.client.waitForEvent("terminated");
  await editor.request("terminate");
  await terminated;
});

test("disconnect ends a program without an end", async () => {
  const editor = await openEditor();
  await editor.launch(programOf(endless));
  await editor.client.configurationDoneRequest();
  await editor.request("disconnect");
});

test("the end of the engine ends the session", async () => {
  const folder = folderOf({ "p.c": program });
  const pid = join(folder, "pid");
  const script = join(folder, "oncard");
  writeFileSync(script, `#!/bin/sh\necho $$ >${pid}\nexec ${oncard} "$@"\n`, { mode: 0o700 });
  const editor = await openEditor();
  await editor.launch(join(folder, "p.c"), { oncard: script, stopOnEntry: true });
  const terminated = editor.client.waitForEvent("terminated");
  process.kill(Number(readFileSync(pid, "utf8")), "SIGKILL");
  await terminated;
  expect(editor.output).toBe(`'${script}' has ended by signal SIGKILL\n`);
  await expect(editor.value("x")).rejects.toThrow("has ended by signal SIGKILL");
});

test.skipIf(withoutModule)(
  "the module walks as the command does, without a file system",
  async () => {
    const walk = async (environment: Record<string, string | undefined>) => {
      const editor = await openEditor({ ...process.env, ...environment });
      await editor.enter(sample("01_sum/two_threads.toml"));
      const seen = [await editor.move("next"), await editor.move("stepBack")];
      const [sum] = await editor.variables(await editor.scope("Globals"));
      await editor.request("continue", { threadId: 1 });
      seen.push(await editor.stopped());
      return { seen, sum, output: editor.output };
    };
    const withModule = await walk({ ONCARD: undefined, ONCARD_MODULE: wasm });
    expect(withModule).toEqual(await walk({ ONCARD: oncard }));
    expect(withModule.output).toMatch("passed");
  },
);

test.skipIf(withoutModule)("a command comes before the module", async () => {
  const editor = await openEditor({ ...process.env, ONCARD: "/nowhere", ONCARD_MODULE: wasm });
  await expect(editor.launch(sample("01_sum/sum.c"))).rejects.toThrow("cannot start '/nowhere'");
});
