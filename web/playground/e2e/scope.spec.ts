// The channels of the scope: cards, handles of their zeros, the scale at the screen.

import { expect, type Page, test } from "@playwright/test";

import { atMaximum, expectAccessible, open, openOwn, status } from "./support.js";

async function run(page: Page): Promise<void> {
  await open(page);
  await openOwn(page);
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toHaveText("Card: finished.");
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
  const screen = await page.locator(".screen").boundingBox();
  const box = await zero.boundingBox();
  if (!screen || !box) throw new Error("the scope is not there");
  const [x, y] = [box.x + 12, box.y + 12];
  await page.mouse.move(x, y);
  await page.mouse.down();
  // Two of eight divisions.
  await page.mouse.move(x, y + (screen.height - 30) / 4, { steps: 4 });
  await page.mouse.up();
  await expect(zero).toHaveAttribute("aria-valuenow", "-2");
  await zero.press("ArrowUp");
  await expect(zero).toHaveAttribute("aria-valuenow", "-1.5");
  await zero.press("End");
  await expect(zero).toHaveAttribute("aria-valuenow", "4");
  await zero.dblclick();
  await expect(zero).toHaveAttribute("aria-valuenow", "0");
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
