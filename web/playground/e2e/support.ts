// What the tests of the page have in common.

import { createRequire } from "node:module";
import { readFileSync } from "node:fs";

import { expect, type Locator, type Page } from "@playwright/test";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const firstLesson = "#lesson=assignment";

/**
 * Opens the page and waits until the card is there; errors of the page fail the test.
 * @param address a fragment, or where another server has the page; without a fragment the first lesson
 */
export async function open(page: Page, address = ""): Promise<void> {
  failWithErrors(page);
  const place = address.startsWith("http") ? address : `./${address}`;
  await page.goto(place.includes("#") ? place : `${place}${firstLesson}`);
  await expect(status(page)).toHaveText(/Card ready|控制卡就绪/);
}

/** Errors of the page fail the test. */
export function failWithErrors(page: Page): void {
  page.on("pageerror", (error) => {
    throw error;
  });
  page.on("console", (message) => {
    if (message.type() === "error") throw new Error(message.text());
  });
}

/** The files of the modules that the page asks for from now on. */
export function modulesOf(page: Page): string[] {
  const modules: string[] = [];
  page.on("request", (request) => {
    const file = new URL(request.url()).pathname.split("/").at(-1) ?? "";
    if (file.endsWith(".wasm")) modules.push(file);
  });
  return modules;
}

export function status(page: Page): Locator {
  return page.locator(".status-text");
}

/** Chooses in the list of the guide, which is opened first where it is a rail. */
export async function chooseLesson(page: Page, lesson: string): Promise<void> {
  const rail = page.locator(".column-rail").getByRole("button", { name: "Lesson" });
  if (await rail.isVisible()) await rail.click();
  await page.getByLabel("Choose a lesson").selectOption(lesson);
}

export async function openOwn(page: Page): Promise<void> {
  await chooseLesson(page, "own");
  await expect(page.getByRole("button", { name: "program.c" })).toBeVisible();
  await expect(status(page)).toHaveText("Card ready.");
}

/** Chooses what the menu of the bar has. */
export async function fromMenu(page: Page, name: string): Promise<void> {
  await page.getByRole("button", { name: "More" }).click();
  await page.getByRole("menuitem", { name }).click();
}

export function editor(page: Page): Locator {
  return page.getByRole("textbox", { name: /^Text of|的文本$/ });
}

/** Replaces the text of the editor, by pasting. */
export async function write(page: Page, text: string): Promise<void> {
  await editor(page).click();
  await page.keyboard.press("Control+A");
  await editor(page).evaluate((element, pasted) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", pasted);
    element.dispatchEvent(
      new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }),
    );
  }, text);
}

export async function text(page: Page): Promise<string> {
  return (await editor(page).locator(".cm-line").allTextContents()).join("\n");
}

/** Runs a program that jogs an axis from line 6 on with its drive off, to the end of the run. */
export async function runUnpowered(page: Page): Promise<void> {
  await openOwn(page);
  await write(
    page,
    "int n;\nint main()\n{\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n  GT_Update(1);\n}\n",
  );
  await expect(page.getByText("No messages")).toBeVisible();
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
}

/** Runs what is loaded, as fast as it can, until it has finished. */
export async function runToEnd(page: Page): Promise<void> {
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toHaveText("Card: finished.");
}

export async function atMaximum(page: Page): Promise<void> {
  await atSpeed(page, Infinity);
}

/** The slider has tenths of a decade, and one place more for the maximum. */
export async function atSpeed(page: Page, speed: number): Promise<void> {
  const slider = page.locator(".slider input");
  if (await slider.isVisible()) {
    await slider.fill(speed === Infinity ? "31" : String(10 * Math.log10(speed)));
  } else {
    await page.locator(".list select").selectOption(String(speed));
  }
}

interface AxeResult {
  violations: { id: string; help: string; nodes: { html: string; failureSummary?: string }[] }[];
}

/** Fails with what axe finds: WCAG 2.1 A and AA, contrast among them, once no color changes. */
export async function expectAccessible(page: Page): Promise<void> {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(async () => {
    const changes = document.getAnimations().filter((each) => each instanceof CSSTransition);
    await Promise.allSettled(changes.map((each) => each.finished));
    const { axe: checker } = globalThis as unknown as {
      axe: { run: (options: unknown) => Promise<AxeResult> };
    };
    return checker.run({ runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"] });
  });
  const found = violations.map(({ id, nodes }) => [
    id,
    ...nodes.map(({ html, failureSummary }) => `${html.slice(0, 160)} ${failureSummary ?? ""}`),
  ]);
  expect(found).toEqual([]);
}
