// Columns that are closed: rails with the names of their panels.

import { expect, type Page, test } from "@playwright/test";

import { editor, expectAccessible, fromMenu, open, openOwn, runUnpowered } from "./support.js";

/** How wide a rail is, and the distance of columns and of the edge of the window. */
const [rail, gap] = [44, 8];

async function widthOf(page: Page, side: string): Promise<number> {
  return (await page.locator(`.column.${side}`).boundingBox())?.width ?? 0;
}

function closing(page: Page, panel: string) {
  return page.getByRole("button", { name: `Close column: ${panel}` });
}

/** The buttons of the rails. */
function names(page: Page) {
  return page.locator(".column-rail").getByRole("button");
}

async function expectNoScrolling(page: Page): Promise<void> {
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(wide).toBeLessThanOrEqual(0);
}

test("a column is closed and opened by the pointer, for its layout, and stays so", async ({
  page,
}) => {
  await open(page, "#lesson=first-axis");
  const before = [await widthOf(page, "middle"), await widthOf(page, "right")];
  await closing(page, "Lesson").click();
  await expect(page.locator("#lesson")).toBeHidden();
  expect(await widthOf(page, "left")).toBe(rail);
  const [middle = 0, right = 0] = [await widthOf(page, "middle"), await widthOf(page, "right")];
  expect(middle).toBeGreaterThan(before[0] ?? 0);
  expect(right).toBeGreaterThan(before[1] ?? 0);
  expect(rail + middle + right + 4 * gap).toBeCloseTo(1440, 0);
  await expectAccessible(page);
  await page.reload();
  await expect(page.locator("#program")).toBeVisible();
  await expect(names(page)).toHaveText(["Lesson"]);
  await names(page).click();
  await expect(page.locator("#lesson")).toBeVisible();
  await closing(page, "Machine").click();
  await page.getByLabel("Choose a lesson").selectOption("lock");
  await expect(page.locator("#machine")).toBeVisible();
  await page.getByLabel("Choose a lesson").selectOption("first-axis");
  await expect(names(page)).toHaveText(["Machine", "Scope", "Timeline"]);
  await fromMenu(page, "Reset layout");
  await expect(names(page)).toHaveCount(0);
  expect(await widthOf(page, "right")).toBe(before[1]);
});

test("the focus goes to the rail, and back into the panel that it opens", async ({ page }) => {
  await open(page, "#lesson=first-axis");
  await closing(page, "Machine").press("Enter");
  await expect(names(page).first()).toBeFocused();
  await expect(names(page).first()).toHaveAttribute("aria-expanded", "false");
  await page.keyboard.press("Tab");
  await expect(names(page).nth(1)).toHaveText("Scope");
  await page.keyboard.press("Enter");
  await expect(names(page)).toHaveCount(0);
  await expect(page.locator("#scope :focus")).toBeInViewport();
});

test("Enter on the border of a column closes it, and opens it as wide as it was", async ({
  page,
}) => {
  await open(page, "#lesson=first-axis");
  const border = page.getByRole("separator", { name: "Width of the right column" });
  await border.press("ArrowLeft");
  const width = await widthOf(page, "right");
  await border.press("Enter");
  await expect.poll(() => widthOf(page, "right")).toBe(rail);
  await expect(border).toBeFocused();
  // 44 of 1424 pixels.
  await expect(border).toHaveAttribute("aria-valuenow", "3");
  await expectAccessible(page);
  await border.press("ArrowLeft");
  await border.press("Enter");
  await expect.poll(() => widthOf(page, "right")).toBeCloseTo(width, 0);
});

test("a border that leaves its column too little closes it, and opens it again", async ({
  page,
}) => {
  await open(page, "#lesson=first-axis");
  const handle = await page
    .getByRole("separator", { name: "Width of the left column" })
    .boundingBox();
  const [x, y] = [(handle?.x ?? 0) + 12, (handle?.y ?? 0) + 300];
  const left = () => widthOf(page, "left");
  const leave = (width: number) => page.mouse.move(gap + width + gap / 2, y);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await leave(130);
  await expect.poll(left).toBeCloseTo(240, 0);
  await leave(110);
  await expect.poll(left).toBe(rail);
  await leave(280);
  await expect.poll(left).toBeCloseTo(280, 0);
  await leave(60);
  await expect.poll(left).toBe(rail);
  await page.mouse.up();
  await page.getByRole("separator", { name: "Width of the left column" }).dblclick();
  // As wide as the layout has it.
  await expect.poll(left).toBe(300);
});

test("the last column that is open cannot be closed", async ({ page }) => {
  await open(page, "#lesson=first-axis");
  await closing(page, "Lesson").click();
  await closing(page, "Program").click();
  await expect(page.getByRole("button", { name: /^Close column/ })).toHaveCount(0);
  await page.getByRole("separator", { name: "Width of the left column" }).press("Enter");
  await expect(names(page)).toHaveText(["Program", "Values"]);
});

test("the opening shows all that it has", async ({ page }) => {
  await page.goto("./");
  await expect(page.getByRole("button", { name: "Start the first lesson" })).toBeVisible();
  const border = page.getByRole("separator", { name: "Width of the left column" });
  await border.press("Enter");
  await border.press("Home");
  await expect.poll(() => widthOf(page, "left")).toBeCloseTo(240, 0);
  await expect(page.getByRole("button", { name: /^Close column/ })).toHaveCount(0);
});

for (const width of [1440, 1024, 800]) {
  test(`what is open takes the room of what is closed at ${width} pixels`, async ({ page }) => {
    await page.setViewportSize({ width, height: 768 });
    await open(page, "#lesson=first-axis");
    await page.getByRole("separator", { name: "Width of the right column" }).press("ArrowLeft");
    for (const [first, second] of [
      ["Lesson", "Program"],
      ["Lesson", "Machine"],
      ["Program", "Machine"],
    ] as const) {
      await closing(page, first).click();
      await expectNoScrolling(page);
      await closing(page, second).click();
      await expectNoScrolling(page);
      const widest = Math.max(
        ...(await Promise.all(["left", "middle", "right"].map((side) => widthOf(page, side)))),
      );
      expect(widest, `beside ${first} and ${second}`).toBe(width - 2 * rail - 4 * gap);
      await fromMenu(page, "Reset layout");
    }
  });
}

test("scope and editor are as wide as their columns after one was closed", async ({ page }) => {
  await open(page, "#lesson=first-axis");
  const canvas = page.locator(".screen canvas");
  const box = page.locator(".screen");
  const fits = async () =>
    ((await canvas.boundingBox())?.width ?? 0) - ((await box.boundingBox())?.width ?? 0);
  const before = (await box.boundingBox())?.width ?? 0;
  await closing(page, "Program").click();
  await expect.poll(async () => (await box.boundingBox())?.width ?? 0).toBeGreaterThan(before);
  await expect.poll(fits).toBeCloseTo(0, 0);
  await names(page).first().click();
  await closing(page, "Machine").click();
  const editor = page.locator(".cm-editor");
  const guide = await widthOf(page, "left");
  await expect
    .poll(async () => (await editor.boundingBox())?.width)
    .toBeCloseTo(1440 - guide - rail - 4 * gap, 0);
  await expect(page.locator(".cm-line").first()).toBeInViewport();
});

test("the guide of a program of one's own is a rail, until it is opened", async ({ page }) => {
  await open(page);
  await page.getByLabel("Choose a lesson").focus();
  await openOwn(page);
  await expect(names(page)).toHaveText(["Lesson"]);
  await expect(names(page)).toBeFocused();
  await expectAccessible(page);
  await page.keyboard.press("Enter");
  const title = page.getByRole("heading", { name: "Your own program" });
  await expect(title).toBeVisible();
  await page.reload();
  await expect(title).toBeVisible();
  await fromMenu(page, "Reset layout");
  await expect(title).toBeHidden();
  await fromMenu(page, "Samples");
  await page.getByRole("button", { name: "Electronic gear" }).click();
  await expect(page.getByRole("heading", { name: "Electronic gear" })).toBeVisible();
});

test("a check and an exploration open the guide, where they say what they find", async ({
  page,
}) => {
  const verdict = page.locator(".verdict");
  await open(page, "#lesson=lost-update");
  await closing(page, "Lesson").click();
  await editor(page).press("F7");
  await expect(verdict).toContainText("Failed");
  await expect(editor(page)).toBeFocused();
  // That of a failing run, with its own places.
  await closing(page, "Lesson").click();
  await closing(page, "Order").click();
  await page.getByRole("button", { name: "Explore" }).click();
  await expect(verdict).toContainText("Failed");
  await expect(page.locator("#interleaving")).toBeVisible();
  await expect(names(page)).toHaveCount(0);
});

test("who opens a lesson sees its guide, and who comes back finds it as it was", async ({
  page,
}) => {
  const guide = page.locator("#lesson");
  await open(page, "#lesson=first-axis");
  await closing(page, "Lesson").click();
  await page.goto("#lesson=lock");
  await expect(guide).toBeVisible();
  await page.goto("#lesson=first-axis");
  await expect(guide).toContainText("Now something moves.");
  await closing(page, "Lesson").click();
  for (const address of ["./#lesson=first-axis", "./"]) {
    await page.goto("about:blank");
    await page.goto(address);
    await expect(names(page)).toHaveText(["Lesson"]);
  }
  // Another lesson about motion.
  await page.goto("about:blank");
  await page.goto("./#lesson=limits");
  await expect(guide).toBeVisible();
});

test("a line, the warnings and the program are shown wherever they are asked for", async ({
  page,
}) => {
  await open(page, "#lesson=assignment");
  await page.getByRole("button", { name: "Statements" }).click();
  await closing(page, "Program").click();
  await page.locator(".listing").getByRole("button", { name: "6" }).first().click();
  await expect(page.locator(".cm-line", { hasText: "answer =" })).toBeInViewport();
  await closing(page, "Program").click();
  await page.getByRole("link", { name: "Skip to the program" }).press("Enter");
  await expect(page.locator("#program :focus")).toBeInViewport();

  await runUnpowered(page);
  const warnings = page.getByRole("button", { name: "2 warnings" });
  await expect(warnings).toBeVisible();
  await closing(page, "Program").click();
  await warnings.click();
  await expect(page.getByRole("group", { name: "Warnings" })).toBeFocused();
  await page.getByRole("button", { name: "Maximise: Scope" }).click();
  await warnings.click();
  await expect(page.getByRole("group", { name: "Warnings" })).toBeFocused();
});

test("a phone has no rails", async ({ page }) => {
  await open(page, "#lesson=first-axis");
  await closing(page, "Lesson").click();
  await page.setViewportSize({ width: 390, height: 844 });
  await expect(page.locator("#lesson")).toBeVisible();
  await expect(names(page)).toHaveCount(0);
  await expect(page.getByRole("button", { name: /^Close column/ })).toHaveCount(0);
});
