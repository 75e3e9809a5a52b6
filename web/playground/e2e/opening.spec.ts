// What a first visit sees: a machine that moves, a line, the first lesson, a program of one's own.

import { readdirSync, readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

import { expect, type Page, test } from "@playwright/test";

import {
  editor,
  expectAccessible,
  failWithErrors,
  fromMenu,
  open,
  openOwn,
  status,
  write,
} from "./support.js";

const star = 'output[data-axis="1"]';

/** The editor holds no more lines than are in sight; this one is. */
async function changePoints(page: Page, to: string): Promise<void> {
  const before = "#define POINTS ";
  await editor(page).locator(".cm-line", { hasText: before }).click();
  await page.keyboard.press("Home");
  await Promise.all(Array.from(before, () => page.keyboard.press("ArrowRight")));
  await page.keyboard.press("Delete");
  await page.keyboard.type(to);
}

test("a first visit sees a table that draws by itself, threads that alternate, and curves", async ({
  page,
}) => {
  failWithErrors(page);
  await page.goto("./");
  await expect(page.getByRole("heading", { name: /Change a number\. Run\./ })).toBeVisible();
  await expect(status(page)).toHaveText("Card running.");
  await expect(page.getByRole("img", { name: /^XY table at/ })).toBeVisible();
  await expect(status(page)).toHaveText("Card: finished.");
  // It ends where it began, after nine lines.
  const [x, y] = [page.locator(star), page.locator('output[data-axis="2"]')];
  await expect(x).toHaveText(/^316[1-7](\.\d)? pulse$/);
  await expect(y).toHaveText(/^13(7[4-9]|80)(\.\d)? pulse$/);
  const turns = page.locator(".lane .turn");
  await expect.poll(() => turns.count()).toBeGreaterThanOrEqual(18);
  await expect(page.locator(".screen")).toHaveAttribute("data-to-ms", /^6\d{3}/);
  expect(new URL(page.url()).hash).toBe("");
});

test("the way of the table is the paler the older it is", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./");
  await expect(status(page)).toHaveText("Card: finished.");
  const way = page.locator(".table .way");
  await expect(way).toHaveCount(8);
  const shades = await way.evaluateAll((parts) =>
    parts.map((each) => Number(each.getAttribute("stroke-opacity"))),
  );
  expect(shades[0]).toBeCloseTo(0.28);
  expect(shades[7]).toBe(1);
});

test("a number is changed while it runs, and Run draws another star", async ({ page }) => {
  await page.goto("./");
  await expect(status(page)).toHaveText("Card running.");
  await changePoints(page, "3");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toHaveText("Card: finished.");
  await expect(page.getByLabel("Change lines", { exact: true })).toHaveValue("3");
});

test("who wants no motion sees the whole star, and nothing that moves", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.addInitScript(() => {
    const said = new Set<string>();
    Object.assign(globalThis, { said });
    new MutationObserver(() => {
      said.add(document.querySelector(".status-text")?.textContent ?? "");
    }).observe(document, { subtree: true, childList: true, characterData: true });
  });
  await page.goto("./");
  await expect(status(page)).toHaveText("Card: finished.");
  await expect(page.locator(star)).toHaveText(/^316[1-7](\.\d)? pulse$/);
  const said = await page.evaluate(() => [
    ...(globalThis as unknown as { said: Set<string> }).said,
  ]);
  expect(said).not.toContain("Card running.");
});

test("the opening leads to the first lesson, and the next visit opens what was open last", async ({
  page,
}) => {
  await page.goto("./");
  await page.getByRole("button", { name: "Start the first lesson" }).click();
  await expect(editor(page)).toContainText("int twice");
  await expect(status(page)).toHaveText("Card ready.");
  await page.goto("about:blank");
  await page.goto("./");
  await expect(editor(page)).toContainText("int twice");
  await expect(status(page)).toHaveText("Card ready.");
  await page.getByLabel("Choose a lesson").selectOption("Welcome");
  await page.getByRole("button", { name: "Write my own program" }).click();
  await expect(page.getByRole("button", { name: "program.c" })).toBeVisible();
});

test("the page takes at most 320 kB beside the modules", () => {
  const folder = new URL("../dist/page/", import.meta.url);
  const sizes = readdirSync(folder)
    .filter((name) => /\.(html|js|css|svg)$/.test(name))
    .map((name) => gzipSync(readFileSync(new URL(name, folder))).length);
  expect(sizes.length).toBeGreaterThan(3);
  expect(sizes.reduce((sum, size) => sum + size)).toBeLessThanOrEqual(320_000);
});

for (const width of [1440, 1024]) {
  test(`no name and no value of a variable is cut off at ${width} pixels`, async ({ page }) => {
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.goto("./");
    await expect(status(page)).toHaveText("Card: finished.");
    const coordinate = page.getByLabel("Change page0.x", { exact: true });
    await coordinate.fill("-123456.109375");
    await coordinate.press("Enter");
    await expect(coordinate).toHaveValue("-123456.109375");
    const cut = await page
      .locator(".variables :is(th, input)")
      .evaluateAll((all) =>
        all
          .filter((each) => each.scrollWidth > each.clientWidth)
          .map((each) => each.textContent || each.ariaLabel),
      );
    expect(cut).toEqual([]);
  });
}

test("a name longer than the panel is cut, and has a title", async ({ page }) => {
  const name = "a_name_of_thirty_one_characters";
  await page.setViewportSize({ width: 1200, height: 900 });
  await open(page);
  await openOwn(page);
  await write(page, `int ${name};\nint main()\n{\n  ${name} = 1;\n}\n`);
  const header = page.getByRole("rowheader", { name });
  await expect(header).toHaveAttribute("title", name);
  const list = page.getByRole("group", { name: "Variables" });
  expect(await list.evaluate((each) => each.scrollWidth - each.clientWidth)).toBeLessThanOrEqual(0);
});

test("what was changed in the opening is kept, and does not run by itself", async ({ page }) => {
  await page.goto("./");
  await expect(status(page)).toHaveText("Card running.");
  await changePoints(page, "5");
  await page.reload();
  await expect(editor(page)).toContainText("POINTS 5");
  await expect(status(page)).toHaveText("Card ready.");
});

test("on a phone the machine moves above the words", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto("./");
  const table = page.getByRole("img", { name: /^XY table at/ });
  const words = page.getByRole("heading", { name: /Change a number/ });
  await expect(table).toBeVisible();
  await expect(words).toBeVisible();
  const [machine, line] = [await table.boundingBox(), await words.boundingBox()];
  expect(machine?.y).toBeLessThan(line?.y ?? 0);
});

test("a click opens a sample as a program of one's own, with what it shows", async ({ page }) => {
  failWithErrors(page);
  await page.goto("./");
  await expect(status(page)).toHaveText("Card running.");
  await expect(page.locator(".thumb")).toHaveCount(10);
  await page.getByRole("button", { name: "Electronic gear" }).click();
  await expect(page.getByRole("button", { name: "gear.c" })).toBeVisible();
  await expect(page.getByRole("heading", { name: "Electronic gear" })).toBeVisible();
  await expect(status(page)).toHaveText("Card ready.");
  await expect(page.locator("output[data-axis]")).toHaveCount(2);
  await fromMenu(page, "Samples");
  const samples = page.getByRole("dialog", { name: "Samples" });
  await expectAccessible(page);
  await samples.getByRole("button", { name: "A handover" }).click();
  await expect(samples).toHaveCount(0);
  await expect(page.getByRole("button", { name: "awaited.c" })).toBeVisible();
  await page.getByLabel("Programs of this lesson").selectOption("Program 2");
  await expect(page.getByRole("button", { name: "gear.c" })).toBeVisible();
});

test("the pictures of the samples move, and stand still for who wants no motion", async ({
  page,
}) => {
  await page.goto("./");
  const pictures = page.locator(".thumb svg");
  await expect(pictures).toHaveCount(10);
  for (const picture of await pictures.all()) {
    expect(await picture.locator("animate").count()).toBeGreaterThan(0);
  }
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.reload();
  await expect(pictures).toHaveCount(10);
  await expect(page.locator("animate")).toHaveCount(0);
});

for (const language of ["en-US", "zh-CN"]) {
  test(`the opening can be read by everybody, ${language}`, async ({ browser }) => {
    const context = await browser.newContext({ locale: language, reducedMotion: "reduce" });
    const page = await context.newPage();
    await page.goto("./");
    await expect(page.locator(star)).toHaveText(/^316/);
    await expectAccessible(page);
    await context.close();
  });
}
