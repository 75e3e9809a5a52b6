// How the panels lie for a lesson.

import { expect, type Page, test } from "@playwright/test";

import { expectAccessible, open, openOwn } from "./support.js";

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
