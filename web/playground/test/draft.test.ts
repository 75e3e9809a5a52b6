import { expect, test } from "vitest";

import { emptyDraft, lessonOf, readDraft } from "../src/share/draft.js";

const start = {
  files: { "program.c": "int x;\n", "scenario.toml": 'program = "program.c"\n' },
  program: "program.c",
  main: "scenario.toml",
};
const draft = { ...emptyDraft, title: "Three", text: "Let `x` become 3.", hints: ["x = 3;", " "] };

test("a draft becomes a lesson; hints without text are left out", () => {
  expect(lessonOf(draft, { ...start, structured: true }, "zh")).toEqual({
    lesson: {
      ...{ version: 1, id: "my-lesson", task: "run", structured: true, ...start },
      title: { en: "Three", zh: "Three" },
      text: { en: "Let `x` become 3.", zh: "Let `x` become 3." },
      hints: [{ en: "x = 3;", zh: "x = 3;" }],
    },
  });
});

test("what is missing is said", () => {
  const parsed = lessonOf({ ...draft, id: "My lesson", title: "" }, start, "en");
  const places = "mistakes" in parsed ? parsed.mistakes.map(({ where }) => where) : [];
  expect(places).toEqual(["id", "title.en"]);
});

test("a draft is read from what the browser has kept", () => {
  expect(readDraft(JSON.parse(JSON.stringify(draft)))).toEqual(draft);
  expect(readDraft({ title: 7, hints: [1, "a"], task: "explore" })).toEqual({
    ...emptyDraft,
    hints: ["a"],
    task: "explore",
  });
  for (const none of [undefined, null, "text"]) expect(readDraft(none)).toEqual(emptyDraft);
});
