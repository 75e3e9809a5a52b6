import { layoutOf, type Lesson, type Mistake, parseLesson } from "@oncard/lessons";
import { describe, expect, test } from "vitest";

function example(): Lesson {
  return {
    version: 1,
    id: "first-lesson",
    title: { en: "Title", zh: "标题" },
    text: { en: "Text\n\twith `code`", zh: "正文" },
    hints: [{ en: "Look.", zh: "看。" }],
    files: { "start.c": "int x;\r\n", "task.toml": 'program = "start.c"\n' },
    program: "start.c",
    main: "task.toml",
    task: "explore",
    structured: true,
    hidden: ['program = "start.c"\nexpect = ["x == 2"]\n'],
    scope: ["axis1.prfPos"],
    layout: "motion",
  };
}

function mistakesOf(value: unknown): Mistake[] {
  const parsed = parseLesson(value);
  return "mistakes" in parsed ? parsed.mistakes : [];
}

test("a lesson is read as it was written", () => {
  const written = JSON.parse(JSON.stringify(example())) as unknown;
  expect(parseLesson(written)).toEqual({ lesson: example() });
});

test("structured, hidden, scope and layout may be missing, and stay so", () => {
  const { structured, hidden, scope, layout, ...rest } = example();
  expect([structured, hidden?.length, scope, layout]).toEqual([
    true,
    1,
    ["axis1.prfPos"],
    "motion",
  ]);
  expect(parseLesson(rest)).toStrictEqual({ lesson: rest });
});

test("a link may name a layout that is not known: the page takes its usual one", () => {
  expect(layoutOf(example())).toBe("motion");
  const lesson = { ...example(), layout: "theatre" };
  expect(parseLesson(lesson)).toEqual({ lesson });
  expect(layoutOf(lesson)).toBeUndefined();
  expect(layoutOf({})).toBeUndefined();
});

test("a text in one language stands for both", () => {
  const lesson = { ...example(), title: { zh: "标题" }, hints: [{ en: "Look." }] };
  expect(parseLesson(lesson)).toMatchObject({
    lesson: { title: { en: "标题", zh: "标题" }, hints: [{ en: "Look.", zh: "Look." }] },
  });
});

test.each([
  ["null", null],
  ["a list", []],
  ["a text", "lesson"],
  ["nothing", undefined],
])("%s is not a lesson", (_, value) => {
  expect(mistakesOf(value)).toEqual([
    { where: "", message: { en: "expected an object", zh: "应为对象" } },
  ]);
});

const long = (size: number) => "x".repeat(size + 1);
const manyFiles = Object.fromEntries(Array.from({ length: 17 }, (_, i) => [`f${i}.c`, "int x;"]));

describe("mistakes name their place and what was expected", () => {
  test.each<[place: string, message: RegExp, change: Record<string, unknown>]>([
    ["", /unknown key 'solution'; expected version, id/, { solution: "x = 1;" }],
    ["version", /^expected 1$/, { version: 2 }],
    ["id", /lower-case letters/, { id: "../x" }],
    ["id", /the text has 65 characters; at most 64/, { id: long(64) }],
    ["title", /expected an object/, { title: "Title" }],
    ["title", /expected a text 'en' or 'zh'/, { title: {} }],
    ["title", /unknown key 'de'; expected en, zh/, { title: { en: "Title", de: "Titel" } }],
    ["title.en", /expected a text/, { title: { en: 7 } }],
    ["title.zh", /the text is empty/, { title: { en: "Title", zh: " " } }],
    ["title.en", /at most 120/, { title: { en: long(120) } }],
    ["text.en", /at most 20000/, { text: { en: long(20_000) } }],
    ["text.zh", /control character/, { text: { zh: "a\u0000" } }],
    ["text.en", /control character/, { text: { en: "turned \u202e round" } }],
    ["hints", /expected a list/, { hints: { en: "Look." } }],
    ["hints", /11 elements; at most 10/, { hints: Array(11).fill({ en: "x" }) }],
    ["hints[1].en", /expected a text/, { hints: [{ en: "x" }, { en: null }] }],
    ["hints[0].en", /at most 2000/, { hints: [{ en: long(2000) }] }],
    ["files", /expected an object/, { files: [] }],
    ["files", /there are 17 entries; at most 16/, { files: { ...manyFiles } }],
    [
      "files",
      /^'a\/b.c': it is not the name of a file/,
      { files: { ...example().files, "a/b.c": "x" } },
    ],
    [
      "files",
      /^'\.\.': it is not the name of a file/,
      { files: { ...example().files, "..": "x" } },
    ],
    [
      "files",
      /is not the name of a file/,
      { files: { ...example().files, [`${long(64)}.c`]: "x" } },
    ],
    ["files.a.h", /expected a text/, { files: { ...example().files, "a.h": 1 } }],
    ["files.a.h", /at most 65536/, { files: { ...example().files, "a.h": long(65_536) } }],
    ["program", /there is no 'other.c' in 'files'/, { program: "other.c" }],
    ["program", /there is no 'constructor.c' in 'files'/, { program: "constructor.c" }],
    ["program", /expected a name with the ending .c/, { program: "task.toml" }],
    ["main", /expected a name with the ending .toml/, { main: "start.c" }],
    ["main", /expected a text/, { main: ["task.toml"] }],
    ["task", /expected 'run' or 'explore'/, { task: "prove" }],
    ["structured", /expected true or false/, { structured: 1 }],
    ["hidden", /expected a list/, { hidden: "" }],
    ["hidden", /5 elements; at most 4/, { hidden: Array(5).fill("x") }],
    ["hidden[0]", /the text is empty/, { hidden: [""] }],
    ["hidden[0]", /at most 65536/, { hidden: [long(65_536)] }],
    ["scope", /expected a list/, { scope: "axis1.prfPos" }],
    ["scope[0]", /at most 64/, { scope: [long(64)] }],
    ["scope", /at most 16/, { scope: Array(17).fill("x") }],
    ["layout", /expected a text/, { layout: 1 }],
    ["layout", /at most 64/, { layout: long(64) }],
  ])("%s: %s", (place, message, change) => {
    const mistakes = mistakesOf({ ...example(), ...change });
    const found = mistakes.find(
      ({ where, message: { en } }) => where === place && message.test(en),
    );
    expect(found, JSON.stringify(mistakes)).toBeDefined();
    expect(found?.message.zh).toMatch(/[一-鿿]/);
  });
});

test("a file cannot replace what objects inherit", () => {
  const files = JSON.parse(
    '{ "__proto__": "x", "start.c": "int x;", "task.toml": "x" }',
  ) as unknown;
  expect(mistakesOf({ ...example(), files })).toMatchObject([{ where: "files" }]);
});

test("every missing key is reported", () => {
  const places = mistakesOf({}).map(({ where }) => where);
  expect(places).toEqual([
    ...["version", "id", "title", "text", "hints", "files", "program", "main", "task"],
  ]);
  expect(mistakesOf({})[0]?.message).toEqual({ en: "it is missing", zh: "缺少此项" });
});

test("mistakes are bounded in number and in length", () => {
  const lesson = Object.fromEntries(
    Array.from({ length: 100 }, (_, i) => [`${long(5000)}${i}`, 0]),
  );
  const mistakes = mistakesOf(lesson);
  expect(mistakes).toHaveLength(20);
  for (const { message } of mistakes) expect(message.en.length).toBeLessThan(300);
});
