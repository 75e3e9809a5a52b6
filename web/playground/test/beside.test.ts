import type { Hint, LineWrites } from "@oncard/engine";
import { expect, test } from "vitest";

import { engineOf } from "../../engine/test/support.js";
import { unitsBeside, valuesBeside } from "../src/editor/beside.js";

const line = (members: Partial<LineWrites>): LineWrites => ({
  thread: 0,
  file: "p.c",
  line: 1,
  moment: 5,
  values: [],
  ...members,
});
const shown = { file: "p.c", lines: ["x = a + 1;", "a[i] = i;", "return x;"], moment: 9 };

test("a line has what it made", () => {
  const written = [
    line({ line: 2, values: [{ name: "a[2]", value: 4 }] }),
    line({ values: [{ name: "x", value: 1.5 }], moment: 8 }),
  ];
  expect(valuesBeside(written, shown)).toEqual([
    { line: 1, text: "x = 1.5", kind: "made", thread: 0, isNumbered: false, isNew: true },
    { line: 2, text: "a[2] = 4", kind: "made", thread: 0, isNumbered: false, isNew: false },
  ]);
});

test("what two threads made stands in their order, with their numbers", () => {
  const values = [{ name: "x", value: 1 }];
  const written = [line({ thread: 3, values }), line({ thread: 1, values })];
  expect(valuesBeside(written, shown)).toMatchObject([
    { thread: 1, isNumbered: true },
    { thread: 3, isNumbered: true },
  ]);
});

test("what stands in the line is not said again", () => {
  const lines = ["x = 4;", "x=4 ;y = x;", "x = 40;"];
  const values = [{ name: "x", value: 4 }];
  const written = [1, 2, 3].map((at) => line({ line: at, values }));
  expect(valuesBeside(written, { ...shown, lines }).map((each) => each.line)).toEqual([3]);
  const returned = [line({ line: 1, result: 0 }), line({ line: 2, result: 0 })];
  const returns = { ...shown, lines: ["return 0;", "return x;"] };
  expect(valuesBeside(returned, returns).map((each) => each.line)).toEqual([2]);
});

test("variables that do not stand in the line are not shown, nor lines of other files", () => {
  const values = [{ name: "tmp_2", value: 7 }];
  expect(valuesBeside([line({ values })], shown)).toEqual([]);
  const ofOther = line({ file: "other.c", values: [{ name: "x", value: 7 }] });
  expect(valuesBeside([ofOther], shown)).toEqual([]);
});

test("a thread's result stands where it ended", () => {
  const written = [line({ line: 3, result: 42 })];
  expect(valuesBeside(written, shown)[0]?.text).toBe("→ 42");
});

test("units stand behind the lines of their arguments, each once", () => {
  const hint = (at: number, unit?: string): Hint => ({
    file: "",
    line: at,
    column: 1,
    end_line: at,
    end_column: 1,
    kind: "argument",
    label: "",
    ...(unit === undefined ? {} : { unit }),
  });
  const hints = [hint(4), hint(2, "pulse/ms"), hint(2, "pulse"), hint(2, "pulse")];
  expect(unitsBeside(hints)).toEqual([{ line: 2, text: "pulse/ms, pulse", kind: "unit" }]);
});

test("the engine says it of a program", async () => {
  const program = "int x;\nint main()\n{\n  x = 6;\n  x = x * 7;\n  return x;\n}\n";
  const engine = await engineOf(program);
  const { state } = await engine.walkForward({ goal: "stop" });
  const { file } = state.threads[0] ?? { file: "" };
  const lines = program.split("\n");
  const written = await engine.written();
  expect(valuesBeside(written, { file, lines, moment: state.moment })).toMatchObject([
    { line: 5, text: "x = 42" },
    { line: 6, text: "→ 42", isNew: true },
  ]);
});
