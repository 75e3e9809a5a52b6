// The editor of the page: breakpoints, and what names are.

import { expect, test } from "@playwright/test";

import { atMaximum, editor, expectAccessible, open, openOwn, status, write } from "./support.js";

const counting = "int x;\nint main()\n{\n  x = 1;\n  x = x + 1;\n  x = x * 3;\n  return x;\n}\n";

test("a run stops at the breakpoints, which are set beside the lines", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(page, counting);
  await expect(page.getByText("No messages")).toBeVisible();
  const besides = async (line: number) => {
    const text = await page
      .locator(".cm-line")
      .nth(line - 1)
      .boundingBox();
    const gutter = await page.locator(".cm-breakpoints").boundingBox();
    if (!text || !gutter) throw new Error("there is no gutter");
    await page.mouse.click(gutter.x + gutter.width / 2, text.y + text.height / 2);
  };
  const list = page.getByRole("group", { name: "Breakpoints" });
  await besides(6);
  await expect(list.getByRole("button")).toHaveText(["6 ×"]);
  await expect(page.locator(".cm-breakpoint:visible")).toHaveCount(1);
  // A line without a statement: the next one that has one.
  await besides(3);
  await expect(list.getByRole("button")).toHaveText(["4 ×", "6 ×"]);

  await atMaximum(page);
  const run = page.getByRole("button", { name: "Run", exact: true });
  await run.click();
  await expect(status(page)).toHaveText("Breakpoint: thread 0 is before line 4.");
  await run.click();
  await expect(status(page)).toHaveText("Breakpoint: thread 0 is before line 6.");
  await expect(page.locator(".cm-next")).toHaveText("  x = x * 3;");
  await expectAccessible(page);
  await list.getByRole("button", { name: "Remove the breakpoint at line 6" }).click();
  await besides(4);
  await expect(list).toHaveCount(0);
  await run.click();
  await expect(status(page)).toHaveText("Card: finished.");
});

// A page that moves under the pointer loses clicks.
test("nothing moves while somebody types", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await page.evaluate(() => {
    const bar = document.querySelector("#program .bar");
    const words = document.querySelector(".clock-word");
    const seen = { places: new Set<string>(), words: new Set<string>() };
    Object.assign(window, { seen });
    const look = () => {
      const { x, y } = bar?.getBoundingClientRect() ?? { x: 0, y: 0 };
      seen.places.add(`${x} ${y}`);
      seen.words.add(words?.textContent.split(" ")[0] ?? "");
      requestAnimationFrame(look);
    };
    look();
  });
  const seen = (what: "places" | "words") =>
    page.evaluate((name) => {
      const { seen: all } = window as unknown as { seen: Record<typeof name, Set<string>> };
      return [...all[name]];
    }, what);
  await write(page, counting);
  await expect.poll(() => seen("words")).toEqual(["ready", "edited"]);
  await expect(page.locator(".clock-word")).toHaveText(/^ready/);
  expect(await seen("places")).toHaveLength(1);
});

test("a click at the number of a line sets its breakpoint", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(page, counting);
  await expect(page.getByText("No messages")).toBeVisible();
  const fifth = page.locator(".cm-lineNumbers .cm-gutterElement").filter({ hasText: /^5$/ });
  await fifth.click();
  await expect(page.getByRole("group", { name: "Breakpoints" }).getByRole("button")).toHaveText([
    "5 ×",
  ]);
  await fifth.click();
  await expect(page.getByRole("group", { name: "Breakpoints" })).toHaveCount(0);
});

test("words are completed while they are typed", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(page, "int speed;\nint main()\n{\n  \n}\n");
  await editor(page).press("Control+Home");
  for (let line = 1; line < 4; ++line) await page.keyboard.press("ArrowDown");
  await page.keyboard.press("End");
  await page.keyboard.type("GT_SetVe");
  const list = page.getByRole("listbox");
  await expect(list.getByRole("option").first()).toContainText("GT_SetVel");
  // A list accepts nothing in its first 75 ms, or while it is being looked up again: a key that was
  // meant for the text must not take a word.
  await expect(page.locator(".cm-tooltip-autocomplete-disabled")).toHaveCount(0);
  await page.waitForTimeout(100);
  await page.keyboard.press("Enter");
  await expect(editor(page)).toContainText("GT_SetVel");
  await page.keyboard.type("(1, spe");
  await expect(list.getByRole("option").first()).toContainText("speed");
  // What the list shows goes with Escape, and the editor keeps the focus.
  await page.keyboard.press("Escape");
  await expect(list).toHaveCount(0);
  await expect(editor(page)).toBeFocused();
});

test("keys of a scenario are completed", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(page, 'program = "program.c"\n');
  await editor(page).press("Control+End");
  await page.keyboard.type("until");
  const list = page.getByRole("listbox");
  await expect(list.getByRole("option").first()).toContainText("until_ms");
});

test("words are completed although more is typed before the answer", async ({ page }) => {
  await page.addInitScript(() => {
    const post = Reflect.get(Worker.prototype, "postMessage");
    Worker.prototype.postMessage = function (this: Worker, ...message: unknown[]) {
      setTimeout(() => {
        Reflect.apply(post, this, message);
      }, 1000);
    };
  });
  await open(page);
  await openOwn(page);
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(page, 'program = "program.c"\n');
  await editor(page).press("Control+End");
  await page.keyboard.type("until", { delay: 150 });
  await expect(page.getByRole("listbox").getByRole("option").first()).toContainText("until_ms");
});

test("breakpoints move with their lines, and have a key", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(page, counting);
  await expect(page.getByText("No messages")).toBeVisible();
  await editor(page).press("Control+Home");
  for (let line = 1; line < 5; ++line) await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Control+F8");
  const list = page.getByRole("group", { name: "Breakpoints" });
  await expect(list.getByRole("button")).toHaveText(["5 ×"]);
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("int y;\n");
  await expect(list.getByRole("button")).toHaveText(["6 ×"]);
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toHaveText("Breakpoint: thread 0 is before line 6.");
  // The scenario has no statements to stop at.
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await expect(page.locator(".cm-breakpoint:visible")).toHaveCount(0);
});

test("a breakpoint that was just set moves with an edit while the page is still busy", async ({
  page,
}) => {
  // Frames and short timers come late, as on a computer with much other work.
  await page.addInitScript(() => {
    const timer = window.setTimeout.bind(window);
    const late = (work: () => void, ms = 0) => timer(work, ms > 0 && ms <= 200 ? 2000 : ms);
    window.setTimeout = late as typeof setTimeout;
    window.requestAnimationFrame = (work) => {
      return late(() => {
        work(performance.now());
      }, 16);
    };
    window.cancelAnimationFrame = window.clearTimeout.bind(window);
  });
  await open(page);
  await openOwn(page);
  await write(page, counting);
  for (let line = 1; line < 5; ++line) await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Control+F8");
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("int y;\n");
  await expect(page.getByRole("group", { name: "Breakpoints" }).getByRole("button")).toHaveText([
    "6 ×",
  ]);
});

test("a run that is asked for while the program is loaded stops at the breakpoints", async ({
  page,
}) => {
  // The card learns of breakpoints late; the page counts what it has loaded.
  await page.addInitScript(() => {
    // eslint-disable-next-line @typescript-eslint/unbound-method
    const post = Worker.prototype.postMessage;
    let loads = 0;
    Worker.prototype.postMessage = function (this: Worker, message: unknown) {
      const asked = String(message);
      if (asked.includes('"load"')) document.body.dataset["loads"] = String(++loads);
      const send = () => {
        post.call(this, message);
      };
      setTimeout(send, asked.includes('"set_stops"') ? 1500 : 0);
    };
  });
  await open(page);
  await openOwn(page);
  const loads = page.locator("body");
  const before = Number(await loads.getAttribute("data-loads"));
  await write(page, counting);
  await editor(page).press("Control+Home");
  for (let line = 1; line < 5; ++line) await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Control+F8");
  await atMaximum(page);
  await expect(loads).toHaveAttribute("data-loads", String(before + 1));
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toHaveText("Breakpoint: thread 0 is before line 5.");
});

test("names are described under the pointer and at the cursor", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(page, "int main()\n{\n  GT_ClrSts(1, 1);\n}\n");
  await expect(page.getByText("No messages")).toBeVisible();
  const description = page.locator(".cm-description");
  const call = page.locator(".cm-line", { hasText: "GT_ClrSts" });
  // The pointer may come before what has just been pasted is read: it then has to move again.
  await expect(async () => {
    await page.mouse.move(0, 0);
    await call.hover({ position: { x: 40, y: 8 } });
    await expect(description).toContainText("GT_ClrSts", { timeout: 2_000 });
  }).toPass();
  await page.mouse.move(0, 0);
  await expect(description).toHaveCount(0);

  await editor(page).press("Control+Home");
  for (const key of ["ArrowDown", "ArrowDown", "End", "ArrowLeft", "ArrowLeft", "ArrowLeft"]) {
    await page.keyboard.press(key);
  }
  for (let left = 0; left < 8; ++left) await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("F1");
  await expect(page.getByRole("status").and(description)).toContainText("GT_ClrSts");
  await page.keyboard.press("Escape");
  await expect(description).toHaveCount(0);
});
