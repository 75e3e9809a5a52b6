// The lessons themselves, judged by the engine: what a student finds fails, what the author wrote
// passes, and both languages say the same.

import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { Engine, type RequestHandler } from "@oncard/engine";
import { ChildProcessTransport } from "@oncard/engine/child-process";
import { collectLessons } from "@oncard/lessons/collect";
import { afterAll, describe, expect, test } from "vitest";

const top = fileURLToPath(new URL("../../../", import.meta.url));
const oncard = resolve(process.env["ONCARD"] ?? `${top}/build/bin/oncard`);
const wasm = `${top}/build/web/oncard-full.wasm`;

const lessons = collectLessons().map((each) => ({ ...each, name: basename(each.folder) }));

/** The table of `oncard test` for the programs that a pattern names. */
function graded(folder: string, pattern: string, scenario = "task.toml"): string {
  const task = join(folder, scenario);
  const args = ["test", task, "--program", join(folder, pattern), "--format=csv"];
  try {
    return execFileSync(oncard, args, { encoding: "utf8" });
  } catch (error) {
    return (error as { stdout: string }).stdout;
  }
}

/** The programs in the text: all of what is marked as C. */
function programsIn(markdown: string): string[] {
  return [...markdown.matchAll(/^```c\n(.*?)^```$/gms)].map((match) => match[1] ?? "");
}

/** What a translation has in common with its original. */
function skeletonOf(markdown: string): string[] {
  return markdown.split("\n").flatMap((line) => /^#+ /.exec(line)?.[0] ?? []);
}

test("there are twelve lessons or more", () => {
  expect(lessons.length).toBeGreaterThanOrEqual(12);
});

describe.each(lessons)("$name", ({ folder, lesson, solution }) => {
  const start = lesson.files[lesson.program] ?? "";
  const scenario = lesson.files[lesson.main] ?? "";

  test("the program at the start does not pass", () => {
    expect(graded(folder, "start.c")).toMatch(/start\.c",no,/);
  });

  test("the solution passes", () => {
    expect(graded(folder, "solution.c")).toMatch(/solution\.c",yes,/);
  });

  test("the solution passes with what is hidden", () => {
    if (lesson.hidden) expect(graded(folder, "solution.c", "hidden.toml")).toMatch(/",yes,/);
  });

  test("the scenarios are proved exactly if the task says so", () => {
    for (const each of [scenario, ...(lesson.hidden ?? [])]) {
      expect(/^explore = "prove"$/m.test(each)).toBe(lesson.task === "explore");
    }
  });

  test("a function that gives results is asked for others, too", () => {
    const questions = (text: string) => text.match(/^init = .*$/gm) ?? [];
    if (!scenario.includes(".result ==")) return;
    const [hidden = ""] = lesson.hidden ?? [];
    expect(questions(hidden).length).toBeGreaterThanOrEqual(3);
    for (const question of questions(hidden)) expect(questions(scenario)).not.toContain(question);
  });

  test("no constant answers all questions", () => {
    const results = [...scenario.matchAll(/thread\d+\.result == (-?\d+)/g)].map(
      ([, value]) => value,
    );
    if (results.length > 0) expect(new Set(results).size).toBeGreaterThanOrEqual(3);
  });

  test("the solution is not in the lesson", () => {
    expect(solution).not.toBe(start);
    expect(JSON.stringify(lesson)).not.toContain(JSON.stringify(solution).slice(1, -1));
  });

  test("there are two or three hints", () => {
    expect([2, 3]).toContain(lesson.hints.length);
  });

  test("every text is in both languages", () => {
    for (const { en, zh } of [lesson.title, lesson.text, ...lesson.hints]) {
      expect(en).not.toMatch(/[一-鿿]/);
      expect(zh).toMatch(/[一-鿿]/);
    }
  });

  test("both texts have the same parts and the same programs", () => {
    expect(skeletonOf(lesson.text.zh)).toEqual(skeletonOf(lesson.text.en));
    expect(programsIn(lesson.text.zh)).toEqual(programsIn(lesson.text.en));
  });

  test("the text is short", () => {
    const words = lesson.text.en.split(/\s+/).length;
    expect(words).toBeGreaterThanOrEqual(150);
    expect(words).toBeLessThanOrEqual(350);
  });
});

// Programs that do what the scenario of a task asks, and not what its text does.
const tricks = [
  {
    of: "01-assignment",
    trick: "answers for the numbers of the task",
    program:
      "int twice(int number)\n{\n  int answer;\n  int is;\n  answer = 42;\n  is = number == 1000;\n" +
      "  if (is) goto lbl_b;\n  is = number == -7;\n  if (is) goto lbl_c;\n  return answer;\n" +
      "lbl_b:\n  return 2000;\nlbl_c:\n  return -14;\n}\n",
    task: true,
  },
  {
    of: "09-inputs",
    trick: "a clock instead of the buttons",
    program:
      "int lamp(int number)\n{\n  int is;\n  is = number == 2;\n  if (is) goto lbl_b;\n" +
      "  GT_Delay(21);\n  GT_SetDoBit(12, 1, 1);\n  GT_Delay(50);\n  GT_SetDoBit(12, 1, 0);\n" +
      "  GT_Delay(130);\n  GT_SetDoBit(12, 1, 1);\n  GT_Delay(50);\n  GT_SetDoBit(12, 1, 0);\n" +
      "  return 0;\nlbl_b:\n  GT_Delay(111);\n  GT_SetDoBit(12, 2, 1);\n  GT_Delay(50);\n" +
      "  GT_SetDoBit(12, 2, 0);\n  return 0;\n}\n",
    task: true,
  },
  {
    of: "10-lost-update",
    trick: "one thread counts everything",
    program:
      "int parts;\nint count(int n)\n{\n  int more;\n  more = n == 2;\n  if (more) goto lbl_end;\n" +
      "  n = n + 2;\nlbl_loop:\n  parts = parts + 1;\n  n = n - 1;\n  more = n > 0;\n" +
      "  if (more) goto lbl_loop;\nlbl_end:\n  return 0;\n}\n",
    task: true,
  },
  {
    of: "11-lock",
    trick: "no lock at all",
    program:
      "int want0;\nint want1;\nint turn;\nint at_table;\nint total;\n" +
      ["first", "second"]
        .map(
          (name) =>
            `int ${name}(int amount)\n{\n  at_table = 1;\n  total = total + amount;\n` +
            "  at_table = 0;\n  return 0;\n}\n",
        )
        .join(""),
    task: false,
  },
  {
    of: "11-lock",
    trick: "the second waits until the first has been",
    program:
      "int want0;\nint want1;\nint turn;\nint at_table;\nint total;\nint first(int amount)\n{\n" +
      "  at_table = 1;\n  total = total + amount;\n  at_table = 0;\n  turn = 1;\n  return 0;\n}\n" +
      "int second(int amount)\n{\n  int wait;\nlbl_wait:\n  wait = turn == 0;\n" +
      "  if (wait) goto lbl_wait;\n  at_table = 1;\n  total = total + amount;\n  at_table = 0;\n" +
      "  return 0;\n}\n",
    task: true,
  },
];

describe("a trick does not solve a task", () => {
  const at = mkdtempSync(join(tmpdir(), "oncard-tricks-"));
  afterAll(() => {
    rmSync(at, { recursive: true });
  });
  test.each(tricks)("$of: $trick", ({ of, program, task }) => {
    const folder = lessons.find(({ name }) => name === of)?.folder ?? "";
    writeFileSync(join(at, "trick.c"), program);
    for (const name of ["task.toml", "hidden.toml"]) {
      writeFileSync(join(at, name), readFileSync(join(folder, name)));
    }
    const passes = (scenario: string) => graded(at, "trick.c", scenario).includes('",yes,');
    expect(passes("task.toml")).toBe(task);
    expect(passes("task.toml") && passes("hidden.toml")).toBe(false);
  });
});

describe("the programs in the texts compile", () => {
  const engine = new Engine(new ChildProcessTransport(oncard));
  afterAll(() => {
    engine.close();
  });
  const programs = lessons.flatMap(({ name, lesson }) =>
    programsIn(lesson.text.en).map((text) => ({ name, text })),
  );
  test.each(programs)("$name", async ({ text }) => {
    const { compiled, diagnostics } = await engine.check({ main: "p.c", files: { "p.c": text } });
    expect(compiled, JSON.stringify(diagnostics)).toBe(true);
  });
});

// What `./x wasm` builds, and a page uses; without it the module is not tested here.
describe.skipIf(!existsSync(wasm))("the module judges alike", async () => {
  const { EngineModule } = (await import(`${top}/web/engine/engine_module.js`)) as {
    EngineModule: { create(bytes: Uint8Array): Promise<RequestHandler> };
  };
  const module = existsSync(wasm) ? await EngineModule.create(readFileSync(wasm)) : undefined;
  const passes = (request: string, args: object) => {
    const { result } = JSON.parse(
      module?.handle(JSON.stringify({ id: 1, request, arguments: args })) ?? "{}",
    ) as { result: { run?: { passed: boolean }; report?: { verdict: string } } };
    return request === "run" ? result.run?.passed : result.report?.verdict === "PROVED";
  };
  test.each(lessons)("$name", ({ lesson, solution }) => {
    const { main, files, program, task } = lesson;
    expect(passes(task, { main, files })).toBe(false);
    expect(passes(task, { main, files: { ...files, [program]: solution } })).toBe(true);
  });
});

test("a teacher grades a class with one command", () => {
  const { folder } = lessons[0] ?? { folder: "" };
  const table = graded(folder, "*.c").split("\r\n");
  expect(table[0]).toBe("scenario,program,passed,time_ms,statements,failures,warnings");
  expect(table.find((row) => row.includes("solution.c"))).toContain(",yes,");
  expect(table.find((row) => row.includes("start.c"))).toContain(",no,");
});
