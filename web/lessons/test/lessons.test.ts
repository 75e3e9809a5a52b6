// The lessons themselves, judged by the engine: what a student finds fails, what the author wrote
// passes, and both languages say the same.

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
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
function graded(folder: string, pattern: string): string {
  const task = join(folder, "task.toml");
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

  test("the scenario is proved exactly if the task says so", () => {
    expect(/^explore = "prove"$/m.test(scenario)).toBe(lesson.task === "explore");
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
