// How the panels lie for a lesson.

import { expect, type Page, test } from "@playwright/test";

import { expectAccessible, fromMenu, open, openOwn } from "./support.js";

async function boxOf(page: Page, panel: string) {
  const box = await page.locator(`#${panel}`).boundingBox();
  if (!box) throw new Error(`${panel} is not there`);
  return { ...box, right: box.x + box.width, bottom: box.y + box.height };
}

test("a lesson about the language has the values and the timeline beside a high program", async ({
  page,
}) => {
  await open(page, "#lesson=assignment");
  const program = await boxOf(page, "program");
  const values = await boxOf(page, "values");
  const timeline = await boxOf(page, "timeline");
  expect(program.height).toBeGreaterThan(800);
  expect(values.x).toBeGreaterThanOrEqual(program.right);
  expect(timeline.y).toBeGreaterThanOrEqual(values.bottom);
  expect(timeline.bottom).toBeLessThanOrEqual(900);
  await expectAccessible(page);
});

test("a lesson about threads has its timeline in half the window, at the top", async ({ page }) => {
  await open(page, "#lesson=lock");
  const timeline = await boxOf(page, "timeline");
  expect(timeline.width).toBeGreaterThan(0.48 * 1440);
  expect(timeline.y).toBeLessThan((await boxOf(page, "machine")).y);
});

test("a lesson about motion has the machine above the scope, both in sight", async ({ page }) => {
  await open(page, "#lesson=first-axis");
  const machine = await boxOf(page, "machine");
  const screen = await page.locator("#scope .screen").boundingBox();
  expect(machine.bottom).toBeLessThan(screen?.y ?? 0);
  expect((screen?.y ?? 0) + (screen?.height ?? 0)).toBeLessThan(900);
  expect((await boxOf(page, "timeline")).y).toBeGreaterThan(screen?.y ?? 0);
});

test("a program of one's own after a lesson has the usual layout", async ({ page }) => {
  await open(page, "#lesson=assignment");
  await openOwn(page);
  const values = await boxOf(page, "values");
  expect(values.x).toBe((await boxOf(page, "program")).x);
  expect((await boxOf(page, "machine")).y).toBeLessThan((await boxOf(page, "timeline")).y);
});

/** Drags the border of a column by so many pixels. */
async function drag(page: Page, name: string, by: number): Promise<void> {
  const border = await page.getByRole("separator", { name }).boundingBox();
  if (!border) throw new Error(`${name} is not there`);
  const [x, y] = [border.x + border.width / 2, border.y + border.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + by, y, { steps: 4 });
  await page.mouse.up();
}

test("the borders of columns are dragged, and stay for their layout", async ({ page }) => {
  await open(page, "#lesson=first-axis");
  const before = await boxOf(page, "program");
  await drag(page, "Width of the left column", 60);
  await drag(page, "Width of the right column", -40);
  const after = await boxOf(page, "program");
  expect(after.x - before.x).toBeCloseTo(60, 0);
  expect(after.right - before.right).toBeCloseTo(-40, 0);
  await page.reload();
  await expect(page.locator("#program")).toBeVisible();
  expect((await boxOf(page, "program")).x).toBeCloseTo(after.x, 0);
  await expectAccessible(page);
  await page.getByLabel("Choose a lesson").selectOption("lock");
  expect((await boxOf(page, "program")).x).toBeCloseTo(before.x, 0);
  await page.getByLabel("Choose a lesson").selectOption("first-axis");
  await fromMenu(page, "Reset layout");
  expect((await boxOf(page, "program")).x).toBeCloseTo(before.x, 0);
  await page.getByRole("button", { name: "More" }).click();
  await expect(page.getByRole("menuitem", { name: "Reset layout" })).toHaveCount(0);
});

test("the arrow keys move a border, and say how wide its column is", async ({ page }) => {
  await open(page, "#lesson=first-axis");
  const border = page.getByRole("separator", { name: "Width of the right column" });
  const { width } = await boxOf(page, "machine");
  await border.press("ArrowLeft");
  await expect.poll(async () => (await boxOf(page, "machine")).width).toBeCloseTo(width + 16, 0);
  await border.press("ArrowRight");
  await border.press("ArrowRight");
  await expect.poll(async () => (await boxOf(page, "machine")).width).toBeCloseTo(width - 16, 0);
  // 400 of 1424 pixels.
  await border.press("Home");
  await expect(border).toHaveAttribute("aria-valuenow", "28");
  await border.press("End");
  await expect.poll(async () => (await boxOf(page, "program")).width).toBeCloseTo(240, 0);
  await border.dblclick();
  await expect.poll(async () => (await boxOf(page, "machine")).width).toBeCloseTo(width, 0);
});

test("the borders of panels are dragged and moved by keys, and stay for their layout", async ({
  page,
}) => {
  await open(page, "#lesson=first-axis");
  const border = page.getByRole("separator", { name: "Height of: Machine" });
  const before = await boxOf(page, "machine");
  const handle = await border.boundingBox();
  const [x, y] = [(handle?.x ?? 0) + 200, (handle?.y ?? 0) + 12];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 120, { steps: 4 });
  await page.mouse.up();
  expect((await boxOf(page, "machine")).height).toBeCloseTo(before.height - 120, 0);
  await border.press("ArrowDown");
  await expect
    .poll(async () => (await boxOf(page, "machine")).height)
    .toBeCloseTo(before.height - 104, 0);
  await page.reload();
  await expect(page.locator("#program")).toBeVisible();
  const { height, bottom } = await boxOf(page, "machine");
  expect(height).toBeCloseTo(before.height - 104, 0);
  expect((await boxOf(page, "scope")).y).toBeCloseTo(bottom + 8, 0);
  await expectAccessible(page);
  await border.press("Home");
  await expect.poll(async () => (await boxOf(page, "machine")).height).toBeCloseTo(40, 0);
  await expect(page.getByRole("button", { name: "Maximise: Machine" })).toBeInViewport();
  await border.dblclick();
  await expect.poll(async () => (await boxOf(page, "machine")).height).toBe(before.height);
});

test("the last panel of a column has what the others leave", async ({ page }) => {
  await open(page, "#lesson=first-axis");
  const border = page.getByRole("separator", { name: "Height of: Program" });
  await border.press("Home");
  await expect.poll(async () => (await boxOf(page, "program")).height).toBeCloseTo(40, 0);
  const values = await boxOf(page, "values");
  expect(values.y).toBeCloseTo((await boxOf(page, "program")).bottom + 8, 0);
  expect(values.bottom).toBeCloseTo(892, 0);
  await border.press("End");
  await expect.poll(async () => (await boxOf(page, "values")).height).toBeCloseTo(96, 0);
  await fromMenu(page, "Reset layout");
  await expect.poll(async () => (await boxOf(page, "values")).height).toBeGreaterThan(200);
});

test("columns that were made wide on a large screen fit on a smaller one", async ({ page }) => {
  await open(page, "#lesson=first-axis");
  await page.getByRole("separator", { name: "Width of the right column" }).press("End");
  for (const width of [1366, 1190, 1024, 800]) {
    await page.setViewportSize({ width, height: 800 });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(wide, `at ${width} pixels`).toBeLessThanOrEqual(0);
    expect((await boxOf(page, "program")).width).toBeGreaterThan(200);
  }
});

test("axes are shown whole in a column of any width", async ({ page }) => {
  await open(page, "#lesson=first-axis");
  const border = page.getByRole("separator", { name: "Width of the right column" });
  const cut = () =>
    page
      .locator(".coordinate")
      .evaluateAll((axes) => axes.map((each) => each.scrollWidth - each.clientWidth));
  for (const width of [1440, 1200]) {
    await page.setViewportSize({ width, height: 900 });
    expect(await cut(), `at ${width} pixels`).toEqual([0, 0]);
  }
  await border.press("Home");
  for (let steps = 0; steps < 20; ++steps) {
    expect(await cut(), `after ${steps} steps`).toEqual([0, 0]);
    await border.press("ArrowLeft");
  }
  await border.press("Home");
  await page.setViewportSize({ width: 1000, height: 900 });
  expect(await cut()).toEqual([0, 0]);
  expect((await boxOf(page, "machine")).width).toBeCloseTo(400, 0);
});

test("the tabs and buttons of the program do not overlap beside several programs", async ({
  page,
}) => {
  await open(page, "#lesson=lost-update");
  await page.getByRole("button", { name: "Copy" }).click();
  await expect(page.getByLabel("Programs of this lesson")).toBeVisible();
  for (const width of [1440, 1200, 1024, 390]) {
    await page.setViewportSize({ width, height: 800 });
    if (width < 760) {
      await page.getByRole("navigation").getByRole("button", { name: "Program" }).click();
    }
    const overlapping = await page.locator("#program").evaluate((panel) => {
      const parts = [...panel.querySelectorAll(".panel-buttons, .bar .tab, .bar .end > *")]
        .filter((part) => part.checkVisibility())
        .map((part) => ({ part, box: part.getBoundingClientRect() }));
      const right = panel.getBoundingClientRect().right;
      return parts
        .filter(
          ({ box: a }, index) =>
            a.right > right ||
            parts
              .slice(index + 1)
              .some(
                ({ box: b }) =>
                  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom,
              ),
        )
        .map(({ part }) => part.textContent);
    });
    expect(overlapping, `at ${width} pixels`).toEqual([]);
  }
});

test("a phone has no borders to drag", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page);
  await expect(page.getByRole("separator")).toHaveCount(0);
});

test("a panel fills the page until Escape, and again when its layout comes back", async ({
  page,
}) => {
  await open(page, "#lesson=first-axis");
  await page.getByRole("button", { name: "Maximise: Scope" }).click();
  await expect(page.locator("#program")).toBeHidden();
  await expect(page.getByRole("separator")).toHaveCount(0);
  const scope = await boxOf(page, "scope");
  expect(scope.width).toBe(1424);
  expect(scope.height).toBeGreaterThan(780);
  await expectAccessible(page);
  await page.reload();
  await expect(page.locator("#scope")).toBeVisible();
  await expect(page.locator("#program")).toBeHidden();
  await page.goto("#lesson=lock");
  await expect(page.locator("#program")).toBeVisible();
  await page.goto("#lesson=first-axis");
  await expect(page.locator("#program")).toBeHidden();
  await page.getByRole("button", { name: "Maximise: Scope" }).press("Escape");
  await expect(page.locator("#program")).toBeVisible();
  await expect(page.getByRole("button", { name: "Maximise: Scope" })).toBeFocused();
});

test("each panel beside the lesson can fill the page, at every size", async ({ page }) => {
  await open(page, "#lesson=lock");
  for (const width of [1440, 1024]) {
    await page.setViewportSize({ width, height: 768 });
    for (const panel of ["Program", "Values", "Machine", "Timeline", "Scope"]) {
      const button = page.getByRole("button", { name: `Maximise: ${panel}` });
      await button.click();
      const box = await boxOf(page, panel.toLowerCase());
      expect(box.width, panel).toBe(width - 16);
      expect(box.bottom, panel).toBe(760);
      const own = await button.boundingBox();
      expect(own && box.right - own.x - own.width, panel).toBeCloseTo(8, 0);
      await button.click();
    }
  }
  await page.setViewportSize({ width: 390, height: 844 });
  await expect(page.getByRole("button", { name: /^Maximise/ })).toHaveCount(0);
});

test("F6 goes to the next panel, also from the editor, and Shift+F6 back", async ({ page }) => {
  await open(page, "#lesson=assignment");
  const focused = () =>
    page.evaluate(() => document.activeElement?.closest(".panel")?.id ?? "nowhere");
  const all = await page.locator("main .panel").evaluateAll((panels) => panels.map(({ id }) => id));
  await page.locator("#program .cm-content").click();
  expect(await focused()).toBe("program");
  await page.keyboard.press("F6");
  expect(await focused()).toBe(all[all.indexOf("program") + 1]);
  await page.keyboard.press("Shift+F6");
  expect(await focused()).toBe("program");
  await page.keyboard.press("Shift+F6");
  expect(await focused()).toBe("lesson");
  await page.keyboard.press("Shift+F6"); // before the first one is the last one
  expect(await focused()).toBe(all.at(-1));
});
