// The channels of the scope: cards, handles of their zeros, the scale at the screen.

import { expect, type Locator, type Page, test } from "@playwright/test";

import { expectAccessible, open, openOwn, runToEnd } from "./support.js";

async function run(page: Page): Promise<void> {
  await open(page);
  await openOwn(page);
  await runToEnd(page);
}

/** Takes a handle by the pointer; what it returns moves it so many divisions up from there. */
async function take(page: Page, handle: Locator): Promise<(divisions: number) => Promise<void>> {
  const screen = await page.locator(".screen").boundingBox();
  const box = await handle.boundingBox();
  if (!screen || !box) throw new Error("the scope is not there");
  const [x, y] = [box.x + 12, box.y + 12];
  await page.mouse.move(x, y);
  await page.mouse.down();
  // There are eight divisions, between edges of 6 and 24 pixels.
  return (divisions) =>
    page.mouse.move(x, y - (divisions * (screen.height - 30)) / 8, { steps: 4 });
}

test("a card has the present value of its channel, its scale and its unit", async ({ page }) => {
  await run(page);
  await page.getByLabel("Add a channel").fill("axis1.prfPos");
  const position = page.getByRole("group", { name: "axis1.prfPos" });
  // The axis has travelled 50 000 pulses.
  await expect(position).toContainText("50000");
  await expect(position).toContainText("20000 per division");
  await expect(position.locator(".unit")).toHaveText("pulse");
  await page.getByRole("button", { name: "To the start" }).click();
  await expect(position.locator("strong")).toHaveText("");
});

test("the channel that is chosen has its knobs, and others do not", async ({ page }) => {
  await run(page);
  const velocity = page.getByRole("group", { name: "axis1.prfVel" });
  await velocity
    .getByRole("button", { name: /axis1.prfVel/ })
    .first()
    .click();
  const units = page.getByLabel("Units per division of axis1.prfVel");
  await units.fill("25");
  await units.press("Enter");
  await expect(velocity).toContainText("25 per division");
  await page.getByLabel("Add a channel").fill("axis1.encPos");
  await expect(units).toHaveCount(0);
  await page.getByRole("button", { name: "Remove axis1.encPos" }).click();
  await expect(page.getByRole("group", { name: "axis1.encPos" })).toHaveCount(0);
  await expectAccessible(page);
});

test("a zero is dragged, moved by keys, and put back by a double click", async ({ page }) => {
  await run(page);
  const zero = page.getByRole("slider", { name: "Offset of axis1.prfVel in divisions" });
  const move = await take(page, zero);
  await move(-2);
  await page.mouse.up();
  await expect(zero).toHaveAttribute("aria-valuenow", "-2");
  await zero.press("ArrowUp");
  await expect(zero).toHaveAttribute("aria-valuenow", "-1.5");
  await zero.press("End");
  await expect(zero).toHaveAttribute("aria-valuenow", "4");
  await zero.dblclick();
  await expect(zero).toHaveAttribute("aria-valuenow", "0");
});

test("the level of the trigger is dragged and moved by keys, on the scale of its source", async ({
  page,
}) => {
  await run(page);
  const handle = page.getByRole("slider", { name: "Level of the trigger on axis1.prfVel" });
  await expect(handle).toHaveCount(0);
  await page.getByLabel("Sweep").selectOption("auto");
  // The whole run is on the screen: 50 pulse/ms take 20 a division.
  await page.locator("#scope").getByRole("combobox", { name: "Time" }).selectOption("5000");
  await expect(page.locator(".screen")).toHaveAttribute("data-to-ms", "5000");
  await expect(page.getByRole("group", { name: "axis1.prfVel" })).toContainText("20 per division");
  await expect(handle).toHaveAttribute("aria-valuetext", "0 pulse/ms");
  const move = await take(page, handle);
  await move(2);
  await page.mouse.up();
  await expect(handle).toHaveAttribute("aria-valuenow", "40");
  await expect(page.getByRole("spinbutton", { name: "Level" })).toHaveValue("40");
  await expect(page.getByText(/^triggered at/)).toBeVisible();
  await handle.press("ArrowDown");
  await expect(handle).toHaveAttribute("aria-valuenow", "30");
  await handle.press("Home");
  await expect(handle).toHaveAttribute("aria-valuenow", "-80");
  await page.getByRole("spinbutton", { name: "Level" }).fill("200");
  await expect(handle).toHaveAttribute("aria-valuetext", "200 pulse/ms, above the screen");
  await expect(handle).toHaveText("T↑");
  await handle.press("ArrowUp");
  await expect(handle).toHaveAttribute("aria-valuenow", "200");
  await handle.press("ArrowDown");
  await expect(handle).toHaveAttribute("aria-valuetext", "80 pulse/ms");
  await expectAccessible(page);
});

test("the scale stays under a level that is dragged, whatever it shows", async ({ page }) => {
  await run(page);
  await page.getByLabel("Sweep").selectOption("auto");
  await page.locator("#scope").getByRole("combobox", { name: "Time" }).selectOption("100");
  await page.getByRole("spinbutton", { name: "Level" }).fill("5");
  const card = page.getByRole("group", { name: "axis1.prfVel" });
  // 75 ms after the trigger the velocity is 5 + 75 · 0.25 pulse/ms.
  await expect(card).toContainText("10 per division");
  const handle = page.getByRole("slider", { name: "Level of the trigger on axis1.prfVel" });
  const screen = page.locator(".screen");
  const before = (await screen.getAttribute("data-to-ms")) ?? "";
  const move = await take(page, handle);
  await move(2);
  await expect(handle).toHaveAttribute("aria-valuenow", "25");
  // The screen shows a later time, whose velocities would take 20 a division.
  await expect(screen).not.toHaveAttribute("data-to-ms", before);
  await move(3);
  await expect(handle).toHaveAttribute("aria-valuenow", "35");
  await page.mouse.up();
  await expect(card).toContainText("20 per division");
});

test("no handle covers another one", async ({ page }) => {
  await run(page);
  const handles = page.locator(".handle");
  await handles.first().press("ArrowUp");
  const boxes = await handles.evaluateAll((elements) =>
    elements.map((each) => each.getBoundingClientRect()),
  );
  expect(boxes).toHaveLength(2);
  const [one, other] = boxes;
  if (!one || !other) throw new Error("a handle is missing");
  // Half a division is less than their height.
  expect(one.bottom).toBeGreaterThan(other.top);
  expect(other.right).toBeLessThanOrEqual(one.left);
});

test("values end at the present, where the screen shows more", async ({ page }) => {
  await run(page);
  await page.getByLabel("Sweep").selectOption("roll");
  await page.locator("#scope").getByRole("combobox", { name: "Time" }).selectOption("5000");
  await page.getByRole("checkbox", { name: "Cursors" }).check();
  await page.getByLabel("Cursor A, ms").fill("2000");
  await page.getByLabel("Cursor B, ms").fill("4000");
  // Axis 1 travels 1300 ms; the run ends at 2500 ms.
  const readings = page.locator('[data-channel="axis1.prfVel"] td');
  await expect(readings).toHaveText(["0", "", "", ""]);
});

/** Whether a line is drawn at a place of the screen, in pixels from its upper left corner. */
async function isDrawn(page: Page, x: number, y: number): Promise<boolean> {
  return page.locator(".screen canvas").evaluate(
    (canvas, at) => {
      const context = (canvas as HTMLCanvasElement).getContext("2d");
      const [x, y] = [at.x * devicePixelRatio, at.y * devicePixelRatio];
      const alpha = context?.getImageData(x, y, 1, 1).data[3] ?? 0;
      return alpha > 128;
    },
    { x, y },
  );
}

test("a digital channel has a lane below the curves", async ({ page }) => {
  await run(page);
  await page.getByLabel("Add a channel").fill("axis1.moving");
  const card = page.getByRole("group", { name: "axis1.moving" });
  await expect(card).toContainText("digital");
  await expect(card.locator("strong")).toHaveText("0");
  await expect(card.getByRole("spinbutton")).toHaveCount(0);
  await expect(page.getByRole("slider", { name: /^Offset of/ })).toHaveCount(2);
  const screen = await page.locator(".screen").boundingBox();
  if (!screen) throw new Error("the scope is not there");
  // Its lane of 22 pixels stands above the times, which have 24: a line for 1 is 5 below its upper edge, one
  // for 0 3 above its lower edge. Axis 1 moves in the first half of the run.
  const [high, low] = [screen.height - 24 - 22 + 5, screen.height - 24 - 3];
  const [early, late] = [56 + 60, screen.width - 40];
  await expect.poll(() => isDrawn(page, early, high)).toBe(true);
  expect(await isDrawn(page, early, low)).toBe(false);
  expect(await isDrawn(page, late, high)).toBe(false);
  expect(await isDrawn(page, late, low)).toBe(true);
  // The divisions end above the lane, and so does the middle of the curves.
  const zero = await page.locator(".handle").first().boundingBox();
  expect((zero?.y ?? 0) + 12 - screen.y).toBeCloseTo(6 + (screen.height - 6 - 22 - 24) / 2, 0);

  await page.getByRole("checkbox", { name: "Cursors" }).check();
  await page.getByLabel("Cursor A, ms").fill("600");
  await page.getByLabel("Cursor B, ms").fill("2400");
  await expect(page.locator('[data-channel="axis1.moving"] td')).toHaveText(["1", "0", "", ""]);
  await expectAccessible(page);
});

test("a digital channel triggers at its edges, without a level", async ({ page }) => {
  await run(page);
  await page.getByLabel("Add a channel").fill("axis2.moving");
  await page.getByLabel("Sweep").selectOption("auto");
  await expect(page.getByRole("spinbutton", { name: "Level" })).toBeVisible();
  await page.getByLabel("Source").selectOption("axis2.moving");
  await expect(page.getByRole("spinbutton", { name: "Level" })).toHaveCount(0);
  await expect(page.getByRole("slider", { name: /^Level of/ })).toHaveCount(0);
  // Axis 2 begins after axis 1 has travelled 1300 ms.
  await expect(page.getByText(/^triggered at 13\d\d/)).toBeVisible();
});

test("a plate on the screen has what the cursors say of the chosen channel", async ({ page }) => {
  await run(page);
  const plate = page.locator(".plate");
  await expect(plate).toHaveCount(0);
  await page.getByRole("checkbox", { name: "Cursors" }).check();
  await page.getByLabel("Cursor A, ms").fill("100");
  await page.getByLabel("Cursor B, ms").fill("150");
  const rows = (channel: string) =>
    page.locator(`[data-channel="${channel}"] td`).nth(2).textContent();
  // The velocity grows by 0.25 pulse/ms in a millisecond; the parts of the screen are of several.
  await expect(plate).toContainText("Δt50 ms");
  await expect(plate).toContainText("1/Δt20 Hz");
  await expect(plate).toContainText(`ΔY${await rows("axis1.prfVel")} pulse/ms`);
  await expect(plate).toContainText(/slope0\.2\d* pulse\/ms²/);
  // Both curves are above their zeros, and higher at the left than at the right.
  await expect(plate).toHaveClass(/bottom/);
  await page.getByRole("button", { name: /^axis2.prfVel/ }).click();
  await expect(plate).toContainText("ΔY0 pulse/ms");
  await page.getByLabel("Add a channel").fill("axis1.moving");
  await expect(plate).not.toContainText("ΔY");
  await expect(plate).toContainText("Δt50 ms");
  // It says nothing that the table does not say, and lets the pointer through.
  await expect(plate).toHaveAttribute("aria-hidden", "true");
  const box = await plate.boundingBox();
  if (!box) throw new Error("the plate is not there");
  await page.mouse.click(box.x + 20, box.y + 10);
  await expect(plate).not.toContainText("Δt50 ms");
  await expectAccessible(page);
});
