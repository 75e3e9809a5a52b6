import { expect, test } from "vitest";

import { lineOfCondition } from "../src/session/required.js";

const scenario = `program = "program.c"
# expect = ["axis1.prfPos == 5"]
expect = [
  "axis1.prfPos == 50",
  "axis1.prfPos == 5", "x == 1 @ 2ms",
  "axis1.prfPos == 5 +- 1",
]
`;

test("a condition is found at its line, not in a comment and not as a part of another one", () => {
  expect(lineOfCondition("axis1.prfPos == 5: axis1.prfPos is 0", scenario)).toBe(5);
  expect(lineOfCondition("axis1.prfPos == 50 does not hold", scenario)).toBe(4);
  expect(lineOfCondition("axis1.prfPos == 5 +- 1不成立", scenario)).toBe(6);
  expect(lineOfCondition("x == 1 @ 2ms: x is 0", scenario)).toBe(5);
  expect(lineOfCondition("x == 1 @ 2ms", scenario)).toBe(5);
});

test("what the scenario does not say has no line", () => {
  expect(lineOfCondition("the run has lasted longer than 60000 ms", scenario)).toBeUndefined();
  expect(lineOfCondition("x == 1", "")).toBeUndefined();
});
