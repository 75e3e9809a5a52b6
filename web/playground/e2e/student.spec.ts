// What a student does: write, mend, run, look, go back, explore, solve.

import { expect, test } from "@playwright/test";

import {
  atMaximum,
  atSpeed,
  chooseLesson,
  editor,
  expectAccessible,
  modulesOf,
  open,
  openOwn,
  runToEnd,
  runUnpowered,
  status,
  text,
  write,
} from "./support.js";

test("a wrong program is mended, runs, is measured and stepped back", async ({ page }) => {
  await open(page);
  await openOwn(page);
  const program = await text(page);
  await write(page, program.replace("trap.acc = 0.25;", "trap.acc = 0.25"));
  const problem = page.getByRole("region", { name: "Messages of the compiler" });
  await expect(problem).toContainText("expected ';'");
  await expect(problem.locator("pre")).toContainText("^");
  await problem.getByRole("button", { name: /^Fix/ }).click();
  await expect(problem).toContainText("No messages");
  expect(await text(page)).toBe(program);

  await runToEnd(page);
  await expect(page.locator('output[data-axis="1"]')).toHaveText("50000 pulse");

  // The axis travels with 50 pulse/ms after 225 ms.
  await page.getByRole("checkbox", { name: "Cursors" }).check();
  await page.getByLabel("Cursor A, ms").fill("500");
  await page.getByLabel("Cursor B, ms").fill("1400");
  const readings = page.locator('tr[data-channel="axis1.prfVel"] td');
  await expect(readings).toHaveText(["50", "0", "-50", "-0.056"]);
  await expect(page.getByText("Δ 900 ms, 1.111 Hz")).toBeVisible();

  const moment = page.getByText(/moment \d+ of \d+/);
  const end = await moment.textContent();
  await page.getByRole("button", { name: "Step back" }).click();
  await expect(moment).not.toHaveText(end ?? "");
  await page.getByRole("button", { name: "Step", exact: true }).click();
  await expect(page.locator(".cm-next")).toHaveCount(0); // the thread has ended again
});

test("what is not finished leaves the last card in sight, and is loaded when it compiles", async ({
  page,
}) => {
  await open(page);
  await openOwn(page);
  const outdated = page.locator(".panel.outdated");
  const axis = page.locator('output[data-axis="1"]');
  const cursor = page.getByRole("slider", { name: "Moment of the session" });
  await write(page, "int x;\nint main()\n{\n  x =\n}\n");
  await expect(page.locator(".problem")).not.toHaveCount(0);
  await expect(outdated).toHaveCount(4);
  await expect(axis).toHaveText("0 pulse");
  await expect(page.locator(".values-panel")).toContainText("trap.acc");
  await expect(cursor).toBeVisible();
  // It cannot run, and is not taken for what is on the card.
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toHaveText(
    "The program has errors; the one before is still on the card.",
  );
  await expect(outdated).toHaveCount(4);
  await expect(page.locator(".values-panel")).toContainText("trap.acc");
  await write(page, "int x;\nint main()\n{\n  x = 1;\n}\n");
  await expect(outdated).toHaveCount(0);
  await expect(page.locator(".values-panel")).not.toContainText("trap.acc");
  await expect(status(page)).toHaveText("Card ready.");
});

for (const [file, wrong] of [
  ["program.c", "int main()\n{\n"],
  ["scenario.toml", "program = 7\n"],
] as const) {
  test(`another project with a wrong ${file} leaves nothing of the last card`, async ({ page }) => {
    await open(page);
    await openOwn(page);
    await page.getByRole("button", { name: file }).click();
    await write(page, wrong);
    await expect(page.locator(".problem")).not.toHaveCount(0);
    const axis = page.locator('output[data-axis="1"]');
    await chooseLesson(page, "assignment");
    await expect(status(page)).toHaveText("Card ready.");
    await expect(axis).toHaveCount(1);
    await chooseLesson(page, "own");
    await expect(axis).toHaveCount(0);
  });
}

test("a program of one's own need not move both axes; what its scenario asks has a line", async ({
  page,
}) => {
  await open(page);
  await openOwn(page);
  await atMaximum(page);
  await write(page, "int x;\nint main()\n{\n  x = 1;\n}\n");
  await expect(page.getByText("No messages")).toBeVisible();
  const run = page.getByRole("button", { name: "Run", exact: true });
  await run.click();
  await expect(status(page)).toHaveText(/^Card: (finished|the scenario's time is over)/);
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(page, 'program = "program.c"\nexpect = ["x == 1",\n  "axis2.prfPos == 5"]\n');
  await run.click();
  await expect(status(page)).toContainText(
    /axis2\.prfPos == 5 does not hold.*\(scenario\.toml, line 3\)/,
  );
});

test("a program that has ended runs again from its start", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await atMaximum(page);
  const run = page.getByRole("button", { name: "Run", exact: true });
  await run.click();
  await expect(status(page)).toHaveText("Card: finished.");
  const axis = page.locator('output[data-axis="1"]');
  await expect(axis).toHaveText("50000 pulse");
  await atSpeed(page, 0.1);
  await run.click();
  await expect(axis).not.toHaveText("50000 pulse");
  await atMaximum(page);
  await expect(status(page)).toHaveText("Card: finished.");
  await expect(axis).toHaveText("50000 pulse");
});

test("a message is mended and shown from another file", async ({ page }) => {
  await open(page);
  await openOwn(page);
  const program = await text(page);
  const wrong = program.replace("trap.acc = 0.25;", "/* 加速度 */ trap.acc = 0.25");
  await write(page, wrong);
  const problem = page.getByRole("region", { name: "Messages of the compiler" });
  await expect(problem).toContainText("expected ';'");
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await expect(editor(page)).toContainText("program =");
  await problem.getByRole("button", { name: /^Fix/ }).click();
  await expect(problem).toContainText("No messages");
  expect(await text(page)).toBe(
    program.replace("trap.acc = 0.25;", "/* 加速度 */ trap.acc = 0.25;"),
  );
  // The correction can be undone, and the scenario is what it was.
  await editor(page).press("Control+z");
  await expect(problem).toContainText("expected ';'");
  expect(await text(page)).toBe(wrong);
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await expect(editor(page)).toContainText("program =");
});

test("exploring finds the lost update, and its run can be walked", async ({ page }) => {
  await open(page, "#lesson=lost-update");
  await page.getByRole("button", { name: "Explore" }).click();
  const verdict = page.locator(".verdict");
  await expect(verdict).toContainText("Failed: an interleaving breaks it.");
  await expect(verdict.locator(".culprit")).toContainText(/thread \d wrote .* over thread/);
  await expect(page.getByText("A recording is being followed.")).toBeVisible();
  const cursor = page.getByRole("slider", { name: "Moment of the session" });
  await expect(status(page)).toContainText("Finished, but");
  const end = Number(await cursor.getAttribute("aria-valuenow"));
  await page.getByRole("button", { name: "Step back" }).click();
  await expect(cursor).toHaveAttribute("aria-valuenow", String(end - 1));
  await page.getByRole("button", { name: "Step", exact: true }).click();
  await expect(cursor).toHaveAttribute("aria-valuenow", String(end));

  // Dragging the cursor to the left end rewinds to the start.
  const track = await page.locator(".track").boundingBox();
  if (!track) throw new Error("there is no timeline");
  await page.mouse.move(track.x + track.width - 3, track.y + 10);
  await page.mouse.down();
  await page.mouse.move(track.x + 1, track.y + 10, { steps: 4 });
  await page.mouse.up();
  await expect(cursor).toHaveAttribute("aria-valuenow", "0");
});

test("dragging over the timeline selects no text", async ({ page }) => {
  await open(page);
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toContainText(/Finished|finished/);
  const number = await page.locator(".scale span").nth(1).boundingBox();
  if (!number) throw new Error("there is no timeline");
  await page.mouse.move(number.x + 1, number.y + number.height / 2);
  await page.mouse.down();
  await page.mouse.move(number.x + 300, number.y + number.height / 2, { steps: 4 });
  expect(await page.evaluate(() => getSelection()?.toString())).toBe("");
  await page.mouse.up();
});

test("scale and cursor of the timeline count in the same unit, the one that was chosen", async ({
  page,
}) => {
  await open(page);
  await openOwn(page);
  await runToEnd(page);
  const numbers = async () => (await page.locator(".scale span").allTextContents()).map(Number);
  const now = page.locator(".now-pill");
  await expect(now).toHaveText("2500 ms");
  // Others would be covered by the number at the cursor.
  await expect.poll(numbers).toEqual([0, 500, 1000]);
  const units = page.getByRole("group", { name: "Unit of the timeline" });
  await units.getByRole("button", { name: "moments" }).click();
  // 10 000 cycles, and 132 511 statements of a loop that waits for the axis.
  await expect(now).toHaveText("moment 142511");
  await expect.poll(numbers).toEqual([0, 50000, 100000]);
  await page.reload();
  await expect(units.getByRole("button", { name: "moments" })).toHaveAttribute(
    "aria-pressed",
    "true",
  );
  await expect(now).toHaveText("moment 0");
});

test("the timeline shows waits and faults of the past", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await atMaximum(page);
  await write(page, "int i;\nint a[3];\nint main()\n{\n  GT_Delay(5);\n  i = 7;\n  a[i] = 1;\n}\n");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  // The delay begins in the first cycle, at 0.25 ms.
  const wait = page.getByRole("img", { name: "line 5: waits until 5.25 ms" });
  await expect(wait).toHaveCount(1);
  await expect(page.getByRole("img", { name: /^line 7: fault: index 7 is out of/ })).toHaveCount(1);
  await page.getByRole("button", { name: "To the start" }).click();
  await expect(wait).toHaveCount(1);
  await expectAccessible(page);
});

test("the interleaving can be chosen", async ({ page }) => {
  await open(page, "#lesson=lost-update");
  await page.getByRole("button", { name: "Step", exact: true }).click();
  const threads = page.getByRole("button", { name: "Threads" });
  await threads.click();
  const executed = (row: number) => page.locator(".values-panel tbody tr").nth(row).locator("td");
  await page.getByRole("button", { name: /^Let thread 1 / }).click();
  await expect(executed(1).nth(3)).toHaveText("1");
  await page.getByRole("button", { name: /^Let thread 1 / }).click();
  await expect(executed(1).nth(3)).toHaveText("2");
});

test("exploring names the case of what a scenario leaves open", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(
    page,
    "int n;\nint sum;\nint add()\n{\n  int copy;\n  copy = sum;\n  sum = copy + n;\n}\n",
  );
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(
    page,
    'program = "program.c"\nglobals = { n = { any = [0, 3] } }\nfinal = ["sum == 2 * n"]\n' +
      '[[thread]]\nfunction = "add"\n[[thread]]\nthread = 1\nfunction = "add"\n',
  );
  await page.getByRole("button", { name: "Explore" }).click();
  const verdict = page.locator(".verdict");
  await expect(verdict).toContainText("choice: n = 1");
  await expect(verdict.locator(".culprit")).toContainText(/thread \d wrote .* over thread/);
  // The failing run is the one of this case.
  await expect(page.getByText("A recording is being followed.")).toBeVisible();
  await expect(page.getByLabel("Change n", { exact: true })).toHaveValue("1");
});

test("a run and a check say which case of a scenario they take", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(page, "int n;\nint main()\n{\n  return n;\n}\n");
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(
    page,
    'program = "program.c"\nglobals = { n = { any = [3, 9] } }\nexpect = ["ret0 == 4"]\n',
  );
  const taken = page.locator(".status").getByText("choice: n = 3", { exact: true });
  await expect(taken).toBeVisible();
  await page.keyboard.press("F7");
  await expect(page.locator(".verdict")).toContainText("choice: n = 3");
  await write(page, 'program = "program.c"\nexpect = ["ret0 == 0"]\n');
  await expect(taken).toHaveCount(0);
});

test("a task is solved, and the progress stays", async ({ page }) => {
  const modules = modulesOf(page);
  await open(page);
  await page.getByRole("button", { name: "Check" }).click();
  const verdict = page.locator(".verdict");
  await expect(verdict).toContainText("Not yet. This does not hold:");
  expect(modules).toEqual(["oncard.wasm"]); // a run needs no other one
  const program = await text(page);
  await write(page, program.replace("answer = 42", "answer = number + number"));
  await page.getByRole("button", { name: "Check" }).click();
  await expect(verdict).toContainText("Solved. All that the task asks holds.");
  await expect(page.getByText("1 of 14 solved")).toBeVisible();
  await page.reload();
  await expect(page.getByText("1 of 14 solved")).toBeVisible();
});

for (const lesson of ["assignment", "lost-update"]) {
  test(`a task that was edited away is not solved: ${lesson}`, async ({ page }) => {
    await open(page, `#lesson=${lesson}`);
    await page.getByRole("button", { name: "task.toml" }).click();
    await write(page, 'program = "start.c"\n');
    await expect(page.getByText("No messages")).toBeVisible();
    await page.getByRole("button", { name: "Check" }).click();
    const verdict = page.locator(".verdict");
    await expect(verdict).toContainText(/Not yet|Failed/);
    await expect(page.getByText("0 of 14 solved")).toBeVisible();
  });
}

test("answers for the numbers of the task alone do not solve it", async ({ page }) => {
  await open(page);
  await write(
    page,
    "int twice(int number)\n{\n  int answer;\n  int is;\n  answer = 42;\n  is = number == 1000;\n" +
      "  if (is) goto lbl_b;\n  is = number == -7;\n  if (is) goto lbl_c;\n  return answer;\n" +
      "lbl_b:\n  return 2000;\nlbl_c:\n  return -14;\n}\n",
  );
  await page.getByRole("button", { name: "Check" }).click();
  const verdict = page.locator(".verdict");
  await expect(verdict).toContainText("but not with other inputs");
  await expect(verdict).toContainText("thread0.result == 10");
  await expect(page.getByText("0 of 14 solved")).toBeVisible();
  await page.getByRole("button", { name: /中文|Chinese/ }).click();
  await expect(verdict).toContainText("其他输入");
});

test("a lock that one thread alone does not pass is shown with its failing run", async ({
  page,
}) => {
  await open(page, "#lesson=lock");
  await write(
    page,
    "int want0;\nint want1;\nint turn;\nint at_table;\nint total;\nint first(int amount)\n{\n" +
      "  at_table = 1;\n  total = total + amount;\n  at_table = 0;\n  turn = 1;\n  return 0;\n}\n" +
      "int second(int amount)\n{\n  int wait;\nlbl_wait:\n  wait = turn == 0;\n" +
      "  if (wait) goto lbl_wait;\n  at_table = 1;\n  total = total + amount;\n  at_table = 0;\n" +
      "  return 0;\n}\n",
  );
  await page.getByRole("button", { name: "Check" }).click();
  const verdict = page.locator(".verdict");
  await expect(verdict).toContainText("but not with other inputs");
  await expect(verdict).toContainText("starvation");
  // What is on the card is not the task that the reader sees, and says so.
  await expect(page.locator(".row-head")).toHaveCount(1);
  await expect(page.locator(".panel.outdated")).toHaveCount(4);
});

test("a failure without one guilty step names none", async ({ page }) => {
  await open(page, "#lesson=lock");
  await page.getByRole("button", { name: "Explore" }).click();
  const verdict = page.locator(".verdict");
  await expect(verdict).toContainText("starvation: thread 0 finds want1 = 1");
  await expect(verdict.locator(".culprit")).toHaveCount(0);
  await expect(verdict.locator("p").filter({ hasText: "preemptions" })).toHaveCount(0);
});

test("a verdict goes when its program is edited", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "Check" }).click();
  const verdict = page.locator(".verdict");
  await expect(verdict).toContainText("Not yet.");
  await editor(page).press("Control+End");
  await page.keyboard.type(" ");
  await expect(verdict).toHaveCount(0);
});

test("hints open one by one", async ({ page }) => {
  await open(page);
  await expect(page.getByText("Hint 1 of")).toHaveCount(0);
  await page.getByRole("button", { name: "Show a hint" }).click();
  await expect(page.getByText(/Hint \d of/)).toHaveCount(1);
});

test("a reload keeps the text, a reset keeps what was written", async ({ page }) => {
  await open(page);
  await write(page, "int mine;\nint main()\n{\n  mine = 7;\n}\n");
  await page.reload();
  await expect(editor(page)).toContainText("mine = 7");
  await page.getByRole("button", { name: "Reset" }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Reset" }).click();
  await expect(editor(page)).not.toContainText("mine = 7");
  await page.getByLabel("Programs of this lesson").selectOption("0");
  await expect(editor(page)).toContainText("mine = 7");
});

test("two tabs keep both texts, and say so", async ({ page, context }) => {
  await open(page);
  const second = await context.newPage();
  await open(second);
  await write(page, "int first;\nint main()\n{\n  first = 1;\n}\n");
  const said = "Edited in another tab, too";
  await expect(second.locator(".status")).toContainText(said);
  await write(second, "int second;\nint main()\n{\n  second = 2;\n}\n");
  await expect(page.locator(".status")).toContainText(said);
  for (const each of [page, second]) {
    await each.reload();
    await expect(each.locator(".status")).not.toContainText(said);
    const programs = each.getByLabel("Programs of this lesson");
    await programs.selectOption("0");
    await expect(editor(each)).toContainText("first = 1");
    await programs.selectOption({ index: (await programs.locator("option").count()) - 1 });
    await expect(editor(each)).toContainText("second = 2");
  }
});

test("an edit can be undone after an exploration has brought another layout", async ({ page }) => {
  await open(page, "#lesson=lost-update");
  await editor(page).click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("int extra;");
  await page.getByRole("button", { name: "Explore", exact: true }).click();
  await expect(page.locator("#interleaving")).toBeVisible();
  await editor(page).click();
  await page.keyboard.press("Control+z");
  await expect.poll(() => text(page)).not.toContain("extra");
});

test("an edit can be undone", async ({ page }) => {
  await open(page);
  const before = await text(page);
  await write(page, "int x;");
  await page.keyboard.press("Control+Z");
  expect(await text(page)).toBe(before);
});

test("a program without an end leaves the page alive", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(page, "int x;\nint main()\n{\nagain:\n  x = x + 1;\n  goto again;\n}\n");
  await expect(page.getByText("No messages")).toBeVisible();
  await atMaximum(page);
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(page, 'program = "program.c"\nlimit_ms = 1000000000\n');
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toHaveText("Card running.");
  await page.getByRole("button", { name: "Statements" }).click();
  await expect(page.locator("table.listing")).toContainText("x := x + 1");
  await expect(page.locator("table.listing .words").first()).toContainText("5040 0001 0000");
  await page.getByRole("button", { name: "Pause" }).click();
  await expect(status(page)).toHaveText("Card ready.");
  // A check of the same program takes long, and can be stopped.
  await page.keyboard.press("F7");
  await page.getByRole("button", { name: "Stop" }).click();
  await expect(page.locator(".verdict")).toContainText("stopped");
});

test("a fault and a refused command are said in words", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(page, "int a[3];\nint main()\n{\n  int i;\n  i = 7;\n  a[i] = 1;\n}\n");
  await expect(page.getByText("No messages")).toBeVisible();
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(page, 'program = "program.c"\n');
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toContainText("fault of thread 0: index 7 is out of bounds");
  await page.getByRole("button", { name: "program.c" }).click();
  await write(page, "int main()\n{\n  GT_PrfJog(1);\n  GT_SetPos(1, 5);\n}\n");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toContainText("Command of thread 0 refused: GT_SetPos");
});

test("warnings of the card are counted, listed and taken back", async ({ page }) => {
  await open(page);
  await runUnpowered(page);
  const mark = page.getByRole("button", { name: "2 warnings" });
  await mark.click();
  const list = page.getByRole("group", { name: "Warnings" });
  await expect(list).toBeFocused();
  const rows = list.locator("tbody tr");
  await expect(rows.first()).toContainText("axis 1 moves while its drive is off");
  await expect(rows.first().locator("td").last()).toHaveText("0.25");
  await expect(rows.last()).toContainText("work-left");
  await expectAccessible(page);
  await rows.first().getByRole("button", { name: "6" }).click();
  await page.getByRole("button", { name: "Statements" }).click();
  await expect(page.locator("tr.linked").first()).toContainText("GT_Update");
  await page.getByRole("button", { name: "Warnings", exact: true }).click();
  await page.getByRole("button", { name: "To the start" }).click();
  await expect(mark).toHaveCount(0);
  await expect(list).toHaveText("There are no warnings up to this moment.");
  await page.getByRole("button", { name: /中文|Chinese/ }).click();
  await expect(page.getByText("到此刻为止没有警告。")).toBeVisible();
});

test("an input is switched", async ({ page }) => {
  await open(page);
  const input = page.getByRole("button", { name: "Input gpi 3" });
  await input.click();
  // It passes the card's filter.
  for (let cycles = 0; cycles < 5; ++cycles) await page.keyboard.press("F9");
  await expect(input).toHaveAttribute("aria-pressed", "true");
});
