// The page itself: links, languages, colours, narrow screens, keys.

import { readFileSync } from "node:fs";

import { expect, test } from "@playwright/test";

import {
  atMaximum,
  atSpeed,
  editor,
  expectAccessible,
  fromMenu,
  open,
  openOwn,
  runToEnd,
  runUnpowered,
  status,
  write,
} from "./support.js";

test("a link opens the same project elsewhere, and the programs there stay", async ({
  page,
  browser,
}) => {
  await open(page);
  await write(page, "int shared;\nint main()\n{\n  shared = 1;\n}\n");
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  const other = await (await browser.newContext()).newPage();
  await open(other, "");
  await write(other, "int mine;\nint main()\n{\n  mine = 1;\n}\n");
  await other.goto(link);
  await expect(editor(other)).toContainText("shared = 1");
  await expect(other.getByRole("alert")).toContainText("opened from a link");
  await other.getByLabel("Programs of this lesson").selectOption("0");
  await expect(editor(other)).toContainText("mine = 1");
  await other.context().close();
});

test("a link leads to where a run was shared, also in a frame of another page", async ({
  page,
  browser,
}) => {
  await open(page);
  await openOwn(page);
  await write(page, "int shared;\nint main()\n{\n  shared = 1;\n  shared = 2;\n  shared = 3;\n}\n");
  const share = page.getByRole("button", { name: "Share" });
  const here = page.getByLabel(/^at moment/);
  await share.click();
  await expect(here).toHaveCount(0);
  await page.keyboard.press("Escape");
  const step = page.getByRole("button", { name: "Step", exact: true });
  await step.click();
  await step.click();
  await expect(page.getByLabel("Change shared", { exact: true })).toHaveValue("2");
  const moment = await page.locator(".clock-moment").textContent();
  await share.click();
  await here.check();
  const frame = await page.getByLabel("In a page of yours").inputValue();
  const other = await (await browser.newContext()).newPage();
  await other.goto(await page.getByRole("textbox", { name: "Link" }).inputValue());
  await expect(other.getByLabel("Change shared", { exact: true })).toHaveValue("2");
  expect(moment).toContain((await other.locator(".clock-moment").textContent())?.split(" of ")[0]);
  await other.route("**/course.html", (route) =>
    route.fulfill({ contentType: "text/html", body: frame }),
  );
  await other.goto("./course.html");
  const framed = other.frameLocator("iframe");
  await expect(framed.getByLabel("Change shared", { exact: true })).toHaveValue("2");
  await other.context().close();

  // What was changed by hand cannot be repeated.
  await page.keyboard.press("Escape");
  await page.getByLabel("Change shared", { exact: true }).fill("7");
  await page.keyboard.press("Enter");
  await share.click();
  await expect(page.getByText("The run was changed by hand")).toBeVisible();
});

for (const [fragment, said] of [
  ["#p1=abcdef", "This link is damaged"],
  ["#p7=abcdef", "This link is of version 7"],
  ["#somewhere", "is not a program of oncard"],
  ["#lesson=nowhere", "There is no lesson 'nowhere' here."],
] as const) {
  test(`the link ${fragment} is explained`, async ({ page }) => {
    await open(page, fragment);
    await expect(page.getByRole("alert")).toContainText(said);
    await expect(editor(page)).toContainText("int twice");
  });
}

test("the page asks nobody else, and its policy is strict", async ({ page }) => {
  const hosts = new Set<string>();
  page.on("request", (request) => hosts.add(new URL(request.url()).host));
  await open(page);
  expect([...hosts]).toEqual([new URL(page.url()).host]);
  const policy = await page
    .locator('meta[http-equiv="Content-Security-Policy"]')
    .getAttribute("content");
  expect(policy).toContain("default-src 'none'");
  expect(policy).not.toContain("unsafe-inline");
});

test("a module that ends starts again, and keeps the text", async ({ page }) => {
  await page.addInitScript(() => {
    const workers: Worker[] = [];
    const { Worker: Original } = globalThis;
    globalThis.Worker = class extends Original {
      constructor(url: string | URL) {
        super(url);
        workers.push(this);
      }
    };
    Object.assign(globalThis, { workers });
  });
  await open(page);
  await page.evaluate(() => {
    const { workers } = globalThis as unknown as { workers: Worker[] };
    const message = new MessageEvent("message", { data: { ended: "the memory is full" } });
    workers[0]?.dispatchEvent(message);
  });
  await expect(status(page)).toContainText("The simulated card has failed (the memory is full)");
  await expect(editor(page)).toContainText("int twice");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(status(page)).toContainText(/[Ff]inished/);
});

test("Chinese, in texts and messages, also after a reload", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: /中文|Chinese/ }).click();
  await expect(page.getByRole("button", { name: "运行", exact: true })).toBeVisible();
  await expect(page.locator("html")).toHaveAttribute("lang", "zh-CN");
  await write(page, "int main()\n{\n  x = 1;\n}\n");
  await expect(page.getByRole("region", { name: "编译器的消息" })).toContainText("未声明");
  await page.reload();
  await expect(page.getByRole("button", { name: "运行", exact: true })).toBeVisible();
  await expectAccessible(page);
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`${colorScheme} colours have enough contrast`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await open(page);
    await openOwn(page);
    await runToEnd(page);
    await page.getByRole("checkbox", { name: "Cursors" }).check();
    await write(page, "int main()\n{\n  x = 1\n}\n");
    await expect(page.locator(".problem")).not.toHaveCount(0);
    await expect(page.locator("html")).toHaveAttribute("data-theme", colorScheme);
    await expectAccessible(page);
  });
}

test("the colours can be chosen", async ({ page }) => {
  await open(page);
  await fromMenu(page, "Colours: system");
  await fromMenu(page, "Colours: light");
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
});

test("the menu of the bar is walked through with keys", async ({ page }) => {
  await open(page);
  const button = page.getByRole("button", { name: "More" });
  const items = page.getByRole("menuitem");
  await button.press("Enter");
  await expect(items).toHaveText(["Samples", "Open…", "Make a lesson", "Keys", "Colours: system"]);
  await expect(items.first()).toBeFocused();
  await page.keyboard.press("ArrowUp");
  await expect(items.last()).toBeFocused();
  await expectAccessible(page);
  await page.keyboard.press("Escape");
  await expect(items).toHaveCount(0);
  await expect(button).toBeFocused();
  await button.click();
  await page.mouse.click(400, 500);
  await expect(items).toHaveCount(0);
  await fromMenu(page, "Keys");
  const rows = page.getByRole("dialog", { name: "Keys" }).getByRole("row");
  await expect(rows.filter({ hasText: "To the next panel" })).toContainText("F6");
  await expect(rows.filter({ hasText: "a panel that fills the page" })).toContainText("Esc");
});

test("the clock says what the card does, and a note only what is more", async ({ page }) => {
  await open(page);
  const clock = page.locator(".clock");
  await expect(clock).toContainText("ready · moment 0 of 0");
  const bar = await page.locator("main").boundingBox();
  expect(bar?.y).toBeLessThanOrEqual(60);
  await openOwn(page);
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(clock).toContainText("2500 ms");
  await expect(clock).toContainText("at the end · moment");
  await page.getByRole("button", { name: "Step back" }).click();
  await expect(clock).toContainText("ready · moment");
  await write(page, "int a[3];\nint main()\n{\n  int i;\n  i = 7;\n  a[i] = 1;\n}\n");
  await expect(page.getByText("No messages")).toBeVisible();
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(clock).toContainText("failed · moment");
  await expect(status(page)).toContainText("fault of thread 0");
  expect((await status(page).boundingBox())?.height).toBeGreaterThan(10);
});

for (const locale of ["en-US", "zh-CN"]) {
  test(`the parts of the bar do not overlap at any width, ${locale}`, async ({ browser }) => {
    const page = await (await browser.newContext({ locale })).newPage();
    await open(page);
    for (let width = 360; width <= 1660; width += 50) {
      await page.setViewportSize({ width, height: 800 });
      const overlapping = await page.locator(".toolbar").evaluate((bar) => {
        const boxes = [...bar.querySelectorAll("h1, button, label")].map((part) => ({
          text: part.textContent,
          box: part.getBoundingClientRect(),
        }));
        return boxes.flatMap(({ text, box: a }, index) =>
          boxes
            .slice(index + 1)
            .filter(({ box: b }) => a.left < b.right && b.left < a.right)
            .filter(({ box: b }) => a.top < b.bottom && b.top < a.bottom)
            .map((other) => `${text} and ${other.text}`),
        );
      });
      expect(overlapping, `at ${width} pixels`).toEqual([]);
    }
    await page.context().close();
  });
}

for (const locale of ["en-US", "zh-CN"]) {
  test(`the bar is one row from 1000 pixels on, ${locale}`, async ({ browser }) => {
    const page = await (await browser.newContext({ locale, reducedMotion: "reduce" })).newPage();
    await page.setViewportSize({ width: 1000, height: 800 });
    await page.goto("./");
    // The clock at its widest: a run of many moments.
    await expect(page.locator(".clock-moment")).toContainText("55723");
    for (const width of [1000, 1024, 1180, 1181, 1440]) {
      await page.setViewportSize({ width, height: 800 });
      const height = await page.locator(".toolbar").evaluate((bar) => bar.clientHeight);
      expect(height, `at ${width} pixels`).toBe(56);
    }
    await page.context().close();
  });
}

for (const width of [390, 1024, 1280, 1440]) {
  test(`the knobs of the scope are above its screen at ${width} pixels`, async ({ page }) => {
    await open(page);
    await openOwn(page);
    await page.setViewportSize({ width, height: 720 });
    if (width < 760) {
      await page.getByRole("navigation").getByRole("button", { name: "Scope" }).click();
    }
    await page.getByLabel("Sweep").selectOption("single");
    const arm = await page.getByRole("button", { name: "Arm" }).boundingBox();
    const csv = await page.getByRole("button", { name: "CSV" }).boundingBox();
    const saved = await page.getByRole("button", { name: "PNG" }).boundingBox();
    const says = await page.getByText("waiting for the trigger").boundingBox();
    const screen = await page.locator(".screen").boundingBox();
    if (!arm || !csv || !saved || !says || !screen) {
      throw new Error("a part of the scope is missing");
    }
    expect(csv.y >= says.y + says.height || csv.x >= says.x + says.width).toBe(true);
    expect(screen.y).toBeGreaterThanOrEqual(arm.y + arm.height);
    expect(screen.y).toBeGreaterThanOrEqual(saved.y + saved.height);
    expect(screen.height).toBeGreaterThanOrEqual(140);
  });
}

for (const { width, height } of [
  { width: 1366, height: 768 },
  { width: 1024, height: 768 },
]) {
  for (const lesson of ["assignment", "first-axis", "limits", "lock"]) {
    test(`nothing of ${lesson} is cut off at the side at ${width} pixels`, async ({ page }) => {
      await page.setViewportSize({ width, height });
      await open(page, `#lesson=${lesson}`);
      const wide = await page
        .locator(".column")
        .evaluateAll((columns) => columns.map((each) => each.scrollWidth - each.clientWidth));
      expect(wide).toEqual([0, 0, 0]);
    });
  }
}

for (const width of [360, 390]) {
  test(`a phone of ${width} pixels shows one panel at a time`, async ({ page }) => {
    await page.setViewportSize({ width, height: 780 });
    await open(page);
    const panels = page.getByRole("navigation", { name: "Parts of the page" });
    for (const name of ["Program", "Machine", "Timeline", "Scope", "Values", "Lesson"]) {
      await panels.getByRole("button", { name }).click();
      await expect(page.locator(".panel:visible")).toHaveCount(1);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(wide, name).toBeLessThanOrEqual(0);
    }
    const bar = await page.locator(".toolbar").boundingBox();
    expect(bar?.height).toBeLessThan(100);
    await expectAccessible(page);
  });

  test(`a run and an exploration on a phone of ${width} pixels come into sight`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height: 780 });
    await open(page, "#lesson=lost-update");
    const run = page.getByRole("button", { name: "Run", exact: true });
    expect((await run.boundingBox())?.height).toBeGreaterThanOrEqual(48);
    await run.click();
    await expect(page.locator("#machine")).toBeVisible();
    await page.getByRole("button", { name: "Explore" }).click();
    await expect(page.locator(".verdict")).toContainText("Failed");
    // Above the transport, when the failing run is on the card and said.
    await expect(status(page)).toContainText("Finished, but");
    const transport = await page.locator(".transport").boundingBox();
    await expect
      .poll(async () => {
        const { y = 0, height = 0 } = (await page.locator(".verdict").boundingBox()) ?? {};
        return y + height;
      })
      .toBeLessThanOrEqual(transport?.y ?? 0);
  });

  test(`card statements and their words fit into ${width} pixels`, async ({ page }) => {
    await page.setViewportSize({ width, height: 780 });
    await open(page);
    await page.getByRole("navigation").getByRole("button", { name: "Values" }).click();
    await page.getByRole("button", { name: "Statements" }).click();
    const list = page.getByRole("group", { name: "Statements" });
    await expect(list.locator(".words").first()).toBeVisible();
    const wide = await list.evaluate((each) => each.scrollWidth - each.clientWidth);
    expect(wide).toBeLessThanOrEqual(0);
    await expectAccessible(page);
  });
}

test("the number of warnings leads to their list on a phone", async ({ page }) => {
  await open(page);
  await runUnpowered(page);
  await page.setViewportSize({ width: 390, height: 844 });
  await page.getByRole("button", { name: "2 warnings" }).click();
  const list = page.getByRole("group", { name: "Warnings" });
  await expect(list).toBeFocused();
  await expect(list).toContainText("axis 1 moves while its drive is off");
  const wide = await list.evaluate((each) => each.scrollWidth - each.clientWidth);
  expect(wide).toBeLessThanOrEqual(0);
  await expectAccessible(page);
  await list.getByRole("button", { name: "6" }).first().click();
  await expect(editor(page)).toBeVisible();
  await expect(page.locator(".cm-linked")).toHaveText("  GT_Update(1);");
});

test("the speed is a slider, which stops at its marks, or a list where the bar is short", async ({
  page,
}) => {
  await open(page);
  const slider = page.getByRole("slider", { name: "Speed" });
  await expect(slider).toHaveAttribute("aria-valuetext", "1×");
  await slider.press("ArrowRight");
  await expect(slider).toHaveAttribute("aria-valuetext", "1.3×");
  await slider.press("End");
  await expect(slider).toHaveAttribute("aria-valuetext", "max");
  await slider.press("Home");
  await expect(slider).toHaveAttribute("aria-valuetext", "0.01×");
  await atSpeed(page, 10 ** 0.5);
  await page.setViewportSize({ width: 1024, height: 768 });
  const list = page.getByRole("combobox", { name: "Speed" });
  await expect(list.getByRole("option")).toHaveText(["0.1×", "1×", "3.2×", "10×", "max"]);
  await list.selectOption("10");
  await page.setViewportSize({ width: 1440, height: 900 });
  await expect(slider).toHaveAttribute("aria-valuetext", "10×");
  // The mark for 1 is near.
  const box = await slider.boundingBox();
  await page.mouse.click((box?.x ?? 0) + 8 + (76 * 20) / 51 + 2, (box?.y ?? 0) + 16);
  await expect(slider).toHaveAttribute("aria-valuetext", "1×");
});

test("everything can be done with keys", async ({ page }) => {
  await open(page);
  const moment = page.getByText(/moment \d+ of \d+/);
  await page.keyboard.press("F8");
  await page.keyboard.press("F8");
  await expect(moment).toHaveText(/moment 3 of 3/);
  await page.keyboard.press("Shift+F8");
  await expect(moment).toHaveText(/moment 2 of 3/);
  await page.keyboard.press("F9");
  await page.keyboard.press("Shift+F9");
  await page.keyboard.press("F4");
  await expect(moment).toHaveText(/moment 0 of/);
  await page.keyboard.press("Control+.");
  await expect(page.getByRole("slider", { name: "Speed" })).toHaveAttribute(
    "aria-valuetext",
    "10×",
  );
  await page.keyboard.press("Control+Enter");
  await expect(status(page)).toContainText("Finished, but");
  // The skip link leads to the program; Escape leaves the editor.
  await page.evaluate(() => {
    (document.activeElement as HTMLElement | null)?.blur();
  });
  await page.keyboard.press("Tab");
  await expect(page.getByRole("link", { name: "Skip to the program" })).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("button", { name: "start.c" })).toBeFocused();
  const cursor = page.getByRole("slider", { name: "Moment of the session" });
  await cursor.focus();
  await page.keyboard.press("Home");
  await expect(cursor).toHaveAttribute("aria-valuenow", "0");
  await page.keyboard.press("ArrowRight");
  await expect(cursor).toHaveAttribute("aria-valuenow", "1");
});

test("an axis with a unit is shown in it: machine, scope, CSV and picture", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await page.getByRole("button", { name: "scenario.toml" }).click();
  const scenario = 'program = "program.c"\n[[world.axis]]\naxis = 1\nunit = "mm"\n';
  await write(page, `${scenario}pulses_per_unit = 1000\n`);
  await runToEnd(page);
  // 50 000 pulses.
  await expect(page.locator('output[data-axis="1"]')).toHaveText("50 mm");
  await page.getByRole("button", { name: "Axes", exact: true }).click();
  await expect(page.locator(".stage").first().locator(".rail-text").last()).toHaveText("100");
  const channel = page.getByRole("group", { name: "axis1.prfVel" });
  await expect(channel.locator(".unit")).toHaveText("mm/s");

  const saved = async (name: string) => {
    const download = page.waitForEvent("download");
    await page.getByRole("button", { name }).click();
    return readFileSync(await (await download).path());
  };
  const [head = "", ...rows] = (await saved("CSV")).toString().trim().split("\n");
  expect(head.split(",")).toContain("axis1.prfVel [mm/s] max");
  expect(head).toMatch(/^time \[ms\],/);
  // 50 pulse/ms.
  const column = head.split(",").indexOf("axis1.prfVel [mm/s] max");
  expect(Math.max(...rows.map((row) => Number(row.split(",")[column])))).toBe(50);
  // Each cycle of 250 us has a row.
  const [titles = "", ...cycles] = (await saved("every cycle")).toString().trim().split("\n");
  const at = titles.split(",").indexOf("axis1.prfVel [mm/s]");
  expect(cycles.slice(0, 2).map((row) => row.split(",")[0])).toEqual(["0.25", "0.5"]);
  expect(Math.max(...cycles.map((row) => Number(row.split(",")[at])))).toBe(50);
  // A line of 18 pixels for the title and each channel, and half of one; the height is at byte 20.
  const lines = 1 + (await page.locator(".channels .channel").count());
  const screen = await page.locator(".screen canvas").evaluate((canvas) => canvas.clientHeight);
  expect((await saved("PNG")).readUInt32BE(20)).toBe(screen + lines * 18 + 9);
});

test("the address names the open lesson, and no program", async ({ page }) => {
  await open(page, "#lesson=lost-update");
  expect(new URL(page.url()).hash).toBe("#lesson=lost-update");
  const choice = page.getByLabel("Choose a lesson");
  await choice.selectOption("assignment");
  await expect(page).toHaveURL(/#lesson=assignment$/);
  await page.goto("./#lesson=lost-update");
  await expect(choice).toHaveValue("lost-update");
  await openOwn(page);
  expect(new URL(page.url()).hash).toBe("");
});

test("a stage has the switches of its scenario, and shows where the axis really is", async ({
  page,
}) => {
  await open(page);
  await openOwn(page);
  await page.getByRole("button", { name: "scenario.toml" }).click();
  // The drive is off in the program below, so the axis stays where it is.
  const limit = '[[world.switch]]\naxis = 1\ntype = "limit_positive"\nfrom = 90000\n';
  await write(page, `program = "program.c"\nuntil_ms = 1500\n${limit}`);
  await page.getByRole("button", { name: "program.c" }).click();
  await write(page, "int main()\n{\n  GT_PrfJog(1);\n  GT_SetVel(1, 20);\n  GT_Update(1);\n}\n");
  await expect(page.getByText("No messages")).toBeVisible();
  const stage = page.locator(".stage").first();
  await expect(stage.locator(".switch title")).toHaveText("positive limit switch");
  await expect(stage.locator(".rail-text").last()).toHaveText("100000");
  await expect(stage.locator(".ghost")).toHaveCount(0);
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(page.locator(".clock")).toContainText("1500 ms");
  await expect(stage.locator(".ghost")).toHaveCount(1);
  const [ghost, carriage] = [".ghost", ".carriage"].map((part) => stage.locator(part));
  const apart = ((await ghost?.boundingBox())?.x ?? 0) - ((await carriage?.boundingBox())?.x ?? 0);
  expect(apart).toBeGreaterThan(50);
  await expectAccessible(page);
});

test("five axes or more have a row each", async ({ page }) => {
  await open(page);
  await openOwn(page);
  const moves = Array.from(
    { length: 12 },
    (_, index) =>
      `  GT_AxisOn(${index + 1});\n  GT_PrfJog(${index + 1});\n  GT_SetVel(${index + 1}, ${index + 1});\n`,
  );
  await write(page, `int main()\n{\n${moves.join("")}  GT_Update(0xFFF);\n}\n`);
  await page.getByRole("button", { name: "scenario.toml" }).click();
  await write(page, 'program = "program.c"\naxes = 12\nuntil_ms = 100\n');
  await expect(page.getByText("No messages")).toBeVisible();
  await atMaximum(page);
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(page.locator(".axis-row")).toHaveCount(12);
  await expect(page.locator(".stage")).toHaveCount(0);
  for (const width of [1440, 390]) {
    await page.setViewportSize({ width, height: 844 });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(wide).toBeLessThanOrEqual(0);
  }
  expect((await page.locator(".axis-row").first().boundingBox())?.height).toBeLessThan(60);
  await expectAccessible(page);
});

test("32 threads have low rows, of which one is chosen", async ({ page }) => {
  await open(page);
  await openOwn(page);
  await write(page, "int f()\n{\n  int n;\n  n = 1;\n  return n;\n}\n");
  await page.getByRole("button", { name: "scenario.toml" }).click();
  const threads = Array.from(
    { length: 32 },
    (_, thread) => `[[thread]]\nthread = ${thread}\nfunction = "f"\n`,
  );
  await write(page, `program = "program.c"\n${threads.join("")}`);
  await expect(page.getByText("No messages")).toBeVisible();
  const list = page.getByRole("listbox", { name: "Threads" });
  await expect(list.getByRole("option")).toHaveCount(32);
  expect((await page.locator("#timeline").boundingBox())?.height).toBeLessThan(520);
  await list.focus();
  await page.keyboard.press("ArrowDown");
  await expect(list.getByRole("option", { selected: true })).toContainText("1 f");
  await list.getByRole("option").nth(31).click();
  await page.getByRole("button", { name: "Let thread 31 execute the next statement" }).click();
  await page.getByRole("button", { name: "Threads" }).click();
  const executed = page.locator(".values-panel tbody tr").nth(31).locator("td").nth(3);
  await expect(executed).toHaveText("1");
  await page.getByRole("button", { name: "program.c" }).click();
  await expectAccessible(page);
});

test("the map of the lessons shows the way, and leads to each", async ({ page }) => {
  await open(page);
  const points = page.getByRole("group", { name: "Lessons" }).getByRole("button");
  await expect(points).toHaveCount(14);
  await expect(points.first()).toHaveAttribute("aria-current", "page");
  const { width = 0, height = 0 } = (await points.nth(1).boundingBox()) ?? {};
  expect(Math.min(width, height)).toBeGreaterThanOrEqual(24);
  await points.first().focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await expect(page.getByRole("heading", { name: "Loops with goto" })).toBeVisible();
  await expect(points.nth(2)).toHaveAttribute("aria-current", "page");
  await expectAccessible(page);
  await write(
    page,
    "int halvings(int n)\n{\n  int count;\n  int done;\n  count = 0;\nlbl_loop:\n  done = n <= 1;\n" +
      "  if (done) goto lbl_end;\n  n = n / 2;\n  count = count + 1;\n  goto lbl_loop;\nlbl_end:\n" +
      "  return count;\n}\n",
  );
  await page.getByRole("button", { name: "Check" }).click();
  await expect(points.nth(2)).toHaveAccessibleName(/\(solved\)$/);
});
