import { readFileSync } from "node:fs";

import { parseLesson } from "@oncard/lessons";
import { expect, test } from "vitest";

test("the example of a lesson is one", () => {
  const page = readFileSync(new URL("../README.md", import.meta.url), "utf8");
  const json = /```json\n(.*?)```/s.exec(page)?.[1] ?? "";
  expect(parseLesson(JSON.parse(json))).toMatchObject({ lesson: { id: "my-first" } });
});
