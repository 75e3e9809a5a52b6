import { expect, test } from "vitest";

import {
  chooseLine,
  layout,
  showLine,
  showPanel,
  showRun,
  showWarnings,
} from "../src/store/layout.js";

test("a line that is shown is chosen, and brings the program to the front", () => {
  showPanel("machine");
  showLine(7);
  expect(layout.front.value).toBe("program");
  expect(layout.chosenLine.value).toBe(7);
  expect(layout.wishedLine.value).toEqual({ line: 7 });
});

test("a line of another file is none of the program", () => {
  showLine(7);
  showPanel("machine");
  showLine(2, "h.h");
  expect(layout.front.value).toBe("program");
  expect(layout.chosenLine.value).toBe(7);
  expect(layout.wishedLine.value).toEqual({ line: 2, file: "h.h" });
});

test("the same line can be wished for again", () => {
  showLine(7);
  const before = layout.wishedLine.value;
  showLine(7);
  expect(layout.wishedLine.value).not.toBe(before);
});

test("the cursor chooses its line without a wish", () => {
  showLine(7);
  const before = layout.wishedLine.value;
  showPanel("values");
  chooseLine(3);
  expect(layout.chosenLine.value).toBe(3);
  expect(layout.wishedLine.value).toBe(before);
  expect(layout.front.value).toBe("values");
});

test("the warnings are shown with the keyboard in their list", () => {
  const before = layout.listWishes.value;
  showWarnings();
  expect([layout.front.value, layout.tab.value]).toEqual(["values", "warnings"]);
  expect(layout.listWishes.value).toBe(before + 1);
});

test("a run comes to the front where nothing of the card is there", () => {
  for (const [before, after] of [
    ["lesson", "machine"],
    ["program", "machine"],
    ["scope", "scope"],
    ["timeline", "timeline"],
  ] as const) {
    showPanel(before);
    showRun();
    expect(layout.front.value).toBe(after);
  }
});
