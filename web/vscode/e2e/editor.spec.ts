// The extension in the editor itself: what a programmer sees and does.

import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

import { expect, type Locator, type Page, test } from "@playwright/test";

const work = fileURLToPath(new URL("../dist/e2e-editor/work", import.meta.url));
const lost = fileURLToPath(new URL("../dist/e2e-editor/lost", import.meta.url));
const star = fileURLToPath(new URL("../dist/e2e-editor/star", import.meta.url));
const search = fileURLToPath(new URL("node_modules/@vscode/ripgrep/bin/rg", import.meta.url));

/** Puts the cursor at the end of a line. */
async function goToLine(page: Page, line: number): Promise<void> {
  await page.keyboard.press("Control+g");
  await page.keyboard.type(`:${line}`);
  await page.keyboard.press("Enter");
  await page.keyboard.press("End");
}

/** Clicks on a lens. The editor draws lenses anew while their file changes, and then forgets clicks. */
async function choose(page: Page, lens: string, effect: Locator): Promise<void> {
  await page.keyboard.press("Control+Home");
  await expect(async () => {
    await page.locator(".codelens-decoration").getByText(lens, { exact: true }).click();
    await expect(effect).not.toHaveCount(0, { timeout: 60_000 });
  }).toPass();
}

/** The line at which the debugger stands. */
async function expectStop(page: Page, text: string): Promise<void> {
  const mark = page.locator(".debug-top-stack-frame-line");
  await expect(mark).toHaveCount(1);
  const lines = page.locator(".view-line", { hasText: text });
  await expect
    .poll(async () => {
      const [at, line] = [await mark.boundingBox(), await lines.first().boundingBox()];
      return at && line ? Math.abs(at.y - line.y) < 3 : false;
    })
    .toBe(true);
}

test("a program is mended, run, and debugged forward and back", async ({ page }) => {
  await page.goto(`./?folder=${work}`);
  await page.getByRole("treeitem", { name: "sum.c" }).dblclick();

  await test.step("it is active", async () => {
    const lenses = page.locator(".codelens-decoration").first();
    await expect(lenses).toHaveText(/run.*debug.*explore/);
  });

  await test.step("a mistake is underlined, and its quick fix mends it", async () => {
    const underlined = page.locator(".squiggly-error");
    await page.locator(".view-line", { hasText: "sum = sum + i" }).click();
    await goToLine(page, 17);
    await page.keyboard.press("Backspace");
    await expect(underlined).not.toHaveCount(0);
    await page.keyboard.press("Control+.");
    await expect(page.locator(".action-widget .action").first()).toContainText("';'");
    await page.keyboard.press("Enter");
    await expect(underlined).toHaveCount(0);
    await expect(page.locator(".view-line", { hasText: "sum = sum + i;" })).toHaveCount(1);
  });

  await test.step("run says whether the scenario holds", async () => {
    await choose(page, "run", page.locator(".output-view-content, .output-view"));
    await expect(page.getByText("passed", { exact: true })).toBeVisible();
  });

  await test.step("debug stops at a breakpoint, and steps back", async () => {
    await page.locator(".view-line", { hasText: "sum = sum + i" }).click();
    await goToLine(page, 17);
    await page.keyboard.press("F9");
    await expect(page.locator(".codicon-debug-breakpoint")).not.toHaveCount(0);
    await choose(page, "debug", page.locator(".debug-toolbar"));
    await expectStop(page, "i = begin;");
    await page.getByRole("button", { name: /^Continue/ }).click();
    await expectStop(page, "sum = sum + i;");
    // Behind the line stands what it has made.
    await expect(page.locator(".view-line", { hasText: "i = begin;" })).toContainText("i = 1");
    await page.getByRole("button", { name: /^Step Back/ }).click();
    await expectStop(page, "if (cc) goto lbl_end;");
    await page.getByRole("button", { name: /^Stop/ }).click();
    await expect(page.locator(".debug-top-stack-frame-line")).toHaveCount(0);
  });

  await test.step("debug of a function stops at its first statement", async () => {
    await choose(page, "debug add", page.locator(".debug-toolbar"));
    await expectStop(page, "i = begin;");
    await page.getByRole("button", { name: /^Continue/ }).click();
    await expectStop(page, "sum = sum + i;");
    await page.getByRole("button", { name: /^Stop/ }).click();
    await expect(page.locator(".debug-top-stack-frame-line")).toHaveCount(0);
  });
});

test("C stands beside card code", async ({ page }) => {
  await page.goto(`./?folder=${work}`);
  await page.getByRole("treeitem", { name: "structured.c" }).dblclick();
  await expect(page.locator(".codelens-decoration").first()).toHaveText(/run.*debug.*explore/);
  await page.keyboard.press("F1");
  await page.keyboard.type("Show C beside Card Code");
  await page.keyboard.press("Enter");
  await expect(page.getByRole("tab", { name: "structured.c beside card code" })).toBeVisible();
  const view = page.frameLocator("iframe.webview").frameLocator("#active-frame");
  const rowOf = (line: number) =>
    view.locator("tr", { has: view.getByRole("button", { name: String(line), exact: true }) });

  await test.step("each statement in the row of what it became", async () => {
    await expect(rowOf(11).locator("code")).toHaveText(["    sum += i;", "  sum = sum + i;"]);
  });

  await test.step("a click at a row goes to its line", async () => {
    await rowOf(12).click();
    await expect(page.getByRole("button", { name: /^Ln 12, Col 1/ })).toBeVisible();
    await expect(rowOf(12)).toHaveClass(/linked/);
    await page.keyboard.press("ArrowUp");
    await expect(rowOf(11)).toHaveClass(/linked/);
    await page.keyboard.press("ArrowDown");
  });

  await test.step("the pointer at a row marks its line", async () => {
    const marked = page.locator(".view-overlays > div", { has: page.locator("[class*='ced-']") });
    await rowOf(11).hover();
    await expect(marked).toHaveCount(1);
    const line = page.locator(".view-line", { hasText: "sum += i;" }).first();
    // The editor draws its lines anew meanwhile.
    await expect
      .poll(async () => {
        const [mark, its] = [await marked.boundingBox(), await line.boundingBox()];
        return mark !== null && mark.y === its?.y;
      })
      .toBe(true);
    await page.locator(".view-line").first().hover();
    await expect(marked).toHaveCount(0);
  });

  await test.step("it follows what is typed, and keeps the rows while there are errors", async () => {
    await page.keyboard.press("End");
    await page.keyboard.press("Backspace");
    await expect(view.getByText("There are errors: this is from before.")).toBeVisible();
    await expect(rowOf(12)).toContainText("i++;");
    await page.keyboard.type(", sum++;");
    await expect(rowOf(12)).toContainText("i++, sum++;");
    await expect(view.getByText("There are errors")).toHaveCount(0);
    await expect(view.getByText("sum = sum + 1;")).toHaveCount(1);
  });

  await test.step("another program is shown as soon as it is in front", async () => {
    await page.getByRole("treeitem", { name: "sum.c" }).dblclick();
    await expect(page.getByRole("tab", { name: "sum.c beside card code" })).toBeVisible();
    await expect(view.getByText("This program is in the card's own C")).toBeVisible();
  });
});

test("a failing run leads to its steps in the debugger, and follows it", async ({ page }) => {
  await page.goto(`./?folder=${lost}`);
  await page.getByRole("treeitem", { name: "lost.toml" }).dblclick();
  const tab = page.getByRole("tab", { name: "lost.toml: failing run" });
  await choose(page, "explore", tab);
  const view = page.frameLocator("iframe.webview").frameLocator("#active-frame");
  const row = (step: number) => view.locator(`#step-${step}`);

  await test.step("it says what is wrong, and from where on", async () => {
    await expect(view.getByRole("heading")).toHaveText("sum is 3, expected 10");
    await expect(view.getByText("From here on, every continuation fails.")).toBeVisible();
    await expect(view.locator("tr.now")).toHaveCount(0);
  });

  await test.step("a click at a step debugs the run from there", async () => {
    await row(9).click();
    await expect(page.locator(".debug-toolbar")).toBeVisible();
    await expect(row(9)).toHaveClass("now");
    await row(4).click();
    await expect(row(4)).toHaveClass("now");
  });

  await test.step("it follows the debugger, and its end", async () => {
    await page.getByRole("button", { name: /^Step Into/ }).click();
    await expect(row(4)).not.toHaveClass("now");
    await expect(view.locator("tr.now")).toHaveCount(1);
    await page.getByRole("button", { name: /^Stop/ }).click();
    await expect(view.locator("tr.now")).toHaveCount(0);
  });
});

test("the machine follows the debugger, and its inputs can be switched", async ({ page }) => {
  await page.goto(`./?folder=${star}`);
  await page.getByRole("treeitem", { name: "star.toml" }).dblclick();
  await choose(page, "debug", page.locator(".debug-toolbar"));
  await page.getByRole("button", { name: "Show the Machine" }).click();
  const view = page.frameLocator("iframe.webview").frameLocator("#active-frame");
  const input = view.getByRole("switch", { name: "Pen is down" });
  await expect(view.getByText("XY plotter")).toBeVisible();

  await test.step("an input is switched", async () => {
    await input.click();
    // It passes the card's filter.
    await expect(async () => {
      await page.getByRole("button", { name: /^Step Out/ }).click();
      await expect(input).toHaveAttribute("aria-checked", "true", { timeout: 500 });
    }).toPass();
  });

  await test.step("at the end of the run the star is drawn", async () => {
    await page.getByRole("button", { name: /^Continue/ }).click();
    const table = view.getByRole("img", { name: /^XY table at 31\d\d.* pulse, 13\d\d.* pulse$/ });
    // It ends where it began, after a long way in all its shades.
    await expect(table.locator("polyline.way")).toHaveCount(8);
  });

  await test.step("afterwards there is no machine", async () => {
    await page.getByRole("button", { name: /^Stop/ }).click();
    await expect(view.getByText("Debug a program: its axes are shown here.")).toBeVisible();
  });
});

test("the scenarios of a folder are tests", async ({ page }) => {
  test.skip(!existsSync(search), "the editor finds no files without ripgrep: install ripgrep");
  const rows = page.locator(".test-explorer .monaco-list-row");
  const row = (name: string) => rows.filter({ hasText: name });
  await page.goto(`./?folder=${work}`);
  await page.getByRole("tab", { name: "Testing" }).click();

  await test.step("they are found without opening one", async () => {
    for (const name of ["one_after_the_other", "one_thread", "two_threads"]) {
      await expect(row(`${name}.toml`)).toHaveCount(1);
    }
  });

  await test.step("they pass", async () => {
    await page.getByRole("button", { name: "Run Tests", exact: true }).click();
    await expect(rows.locator(".codicon-testing-passed-icon")).toHaveCount(3);
  });

  await test.step("one whose values are others fails", async () => {
    const scenario = `${work}/two_threads.toml`;
    const text = readFileSync(scenario, "utf8");
    expect(text).toContain("5050");
    writeFileSync(scenario, text.replaceAll("5050", "5051"));
    await page.getByRole("button", { name: "Run Tests", exact: true }).click();
    await expect(row("two_threads.toml").locator(".codicon-testing-failed-icon")).toHaveCount(1);
    await expect(row("one_thread.toml").locator(".codicon-testing-passed-icon")).toHaveCount(1);
  });
});
