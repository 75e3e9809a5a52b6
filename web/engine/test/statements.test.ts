import { expect, test } from "vitest";

import { executedAt, statementsOf } from "../src/statements.js";

// A cycle begins before the first turn, and another one between the last two.
const turns = [
  { moment: 1, time_ms: 0, thread: 0, statements: 2 },
  { moment: 3, time_ms: 0, thread: 1, statements: 1 },
  { moment: 5, time_ms: 0.25, thread: 0, statements: 1 },
];

test("each statement of a turn has the moment after it", () => {
  expect(statementsOf(turns)).toEqual([
    { thread: 0, moment: 2 },
    { thread: 0, moment: 3 },
    { thread: 1, moment: 4 },
    { thread: 0, moment: 6 },
  ]);
});

test("a moment is after the statements that were executed until then", () => {
  const statements = statementsOf(turns);
  const moments = [0, 1, 2, 3, 4, 5, 6, 7];
  expect(moments.map((moment) => executedAt(statements, moment))).toEqual([0, 0, 1, 2, 3, 3, 4, 4]);
});
