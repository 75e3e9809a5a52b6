// What can be hit with a finger or a pointer has 24 × 24 pixels or more (WCAG 2.2, 2.5.8). Links in running
// text, and what the height of a line of code limits, may be smaller.

import { expect, type Page, test } from "@playwright/test";

import { editor, fromMenu, open, openOwn, runUnpowered, status, write } from "./support.js";

const least = 24;

/** The targets in sight that are too small, with their sizes. */
async function small(page: Page): Promise<string[]> {
  return page.evaluate((size) => {
    const targets =
      "button, a[href], input, select, textarea, summary, tr[aria-selected], " +
      '[role="slider"], [role="separator"], [role="menuitem"], [tabindex]:not([tabindex="-1"])';
    return [...document.querySelectorAll<HTMLElement>(targets)].flatMap((each) => {
      const isMark = each.matches('[type="checkbox"], [type="radio"]');
      const target = (isMark ? each.closest("label") : null) ?? each;
      const { width, height, right } = target.getBoundingClientRect();
      const isSeen = each.checkVisibility({ visibilityProperty: true }) && right > 0;
      const isHidden = each.closest(".visually-hidden, .track > svg, .cm-content, .uplot") !== null;
      const isInText = each.matches(".prose :is(p, li) a");
      if (!isSeen || isHidden || isInText || Math.min(width, height) >= size - 0.5) return [];
      const name = each.getAttribute("aria-label") ?? each.textContent;
      return [`${each.tagName} ${name}: ${Math.round(width)} × ${Math.round(height)}`];
    });
  }, least);
}

/** On phones one panel after the other, otherwise all of them at once. */
async function expectLarge(page: Page, where: string): Promise<void> {
  const panels = page.getByRole("navigation", { name: "Parts of the page" }).getByRole("button");
  const count = (await panels.first().isVisible()) ? await panels.count() : 0;
  if (count === 0) expect(await small(page), where).toEqual([]);
  for (let index = 0; index < count; ++index) {
    await panels.nth(index).click();
    expect(await small(page), `${where}, panel ${index}`).toEqual([]);
  }
}

for (const { width, height } of [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
]) {
  test.describe(`at ${width} pixels`, () => {
    test.use({ viewport: { width, height }, contextOptions: { reducedMotion: "reduce" } });

    test("every target of the opening is large enough", async ({ page }) => {
      await page.goto("./");
      await expect(status(page)).toHaveText("Card: finished.");
      await expectLarge(page, "opening");
    });

    test("every target of a lesson and of its failing run is large enough", async ({ page }) => {
      await open(page, "#lesson=lost-update");
      await page.getByRole("button", { name: "Show a hint" }).click();
      await expectLarge(page, "lesson");
      await page.getByRole("button", { name: "Explore" }).click();
      await expect(page.locator(".now-pill")).toHaveText("after step 32");
      await expectLarge(page, "failing run");
    });

    test("every target of menu and dialogs is large enough", async ({ page }) => {
      await open(page);
      await page.getByRole("button", { name: "More" }).click();
      await expect(page.getByRole("menuitem").first()).toBeVisible();
      expect(await small(page), "menu").toEqual([]);
      await page.keyboard.press("Escape");
      for (const name of ["Samples", "Make a lesson", "Keys"]) {
        await fromMenu(page, name);
        await expect(page.getByRole("dialog")).toBeVisible();
        expect(await small(page), name).toEqual([]);
        await page.keyboard.press("Escape");
      }
      await page.getByRole("button", { name: "Share" }).click();
      await expect(page.getByRole("dialog")).toBeVisible();
      expect(await small(page), "Share").toEqual([]);
    });
  });
}

for (const width of [1440, 390]) {
  test(`every target of tables, messages and the scope is large enough at ${width} pixels`, async ({
    page,
  }) => {
    await open(page);
    await runUnpowered(page);
    await expect(page.getByRole("button", { name: "2 warnings" })).toBeVisible();
    await page.getByRole("checkbox", { name: "Cursors" }).check();
    await page.getByLabel("Sweep").selectOption("single");
    await editor(page).locator(".cm-line").nth(3).click();
    await page.keyboard.press("Control+F8");
    await page.setViewportSize({ width, height: 844 });
    for (const tab of ["Threads", "Statements", "C and card", "Warnings"]) {
      if (width < 760) {
        await page.getByRole("navigation").getByRole("button", { name: "Values" }).click();
      }
      await page.getByRole("button", { name: tab, exact: true }).click();
      await expectLarge(page, tab);
    }
    if (width < 760) {
      await page.getByRole("navigation").getByRole("button", { name: "Program" }).click();
    }
    await write(page, "int main()\n{\n  x = 1\n}\n");
    await expect(page.locator(".problem")).not.toHaveCount(0);
    await expectLarge(page, "messages");
  });
}

test("every target of many threads is large enough, but for the rows of their list", async ({
  page,
}) => {
  await open(page);
  await openOwn(page);
  await write(page, "int f()\n{\n  int n;\n  n = 1;\n  return n;\n}\n");
  await page.getByRole("button", { name: "scenario.toml" }).click();
  const threads = Array.from(
    { length: 12 },
    (_, thread) => `[[thread]]\nthread = ${thread}\nfunction = "f"\n`,
  );
  await write(page, `program = "program.c"\n${threads.join("")}`);
  const list = page.getByRole("listbox", { name: "Threads" });
  await expect(list.getByRole("option")).toHaveCount(12);
  expect(await small(page)).toEqual([]);
});
