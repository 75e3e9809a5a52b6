// The walk of a student from a wrong program to a solved task: on a desk and on a phone, in English and
// Chinese. student.spec.ts has each of its steps by itself.

import { expect, type Page, test } from "@playwright/test";

import { atMaximum, expectAccessible, open, status, text, write } from "./support.js";

interface Words {
  panels: Record<"lesson" | "program" | "timeline" | "scope", string>;
  problems: string;
  none: string;
  fix: RegExp;
  run: string;
  finished: string;
  cursors: string;
  cursorA: string;
  cursorB: string;
  back: string;
  moment: RegExp;
  explore: string;
  failed: string;
  lost: string;
  afterStep2: string;
  check: string;
  solved: string;
  progress: string;
}

const english: Words = {
  panels: { lesson: "Lesson", program: "Program", timeline: "Timeline", scope: "Scope" },
  problems: "Messages of the compiler",
  none: "No messages: the program compiles.",
  fix: /^Fix/,
  run: "Run",
  finished: "Card: finished.",
  cursors: "Cursors",
  cursorA: "Cursor A, ms",
  cursorB: "Cursor B, ms",
  back: "Step back",
  moment: /moment \d+ of \d+/,
  explore: "Explore",
  failed: "Failed: an interleaving breaks it.",
  lost: "parts is 12, expected 15",
  afterStep2: "after step 2",
  check: "Check",
  solved: "Solved. It is proved for every interleaving.",
  progress: "1 of 14 solved",
};

const chinese: Words = {
  panels: { lesson: "课程", program: "程序", timeline: "时间线", scope: "示波器" },
  problems: "编译器的消息",
  none: "没有消息：程序可以编译。",
  fix: /^修正/,
  run: "运行",
  finished: "控制卡：已结束。",
  cursors: "光标",
  cursorA: "光标 A, ms",
  cursorB: "光标 B, ms",
  back: "退一步",
  moment: /第 \d+ 时刻，共 \d+/,
  explore: "探索",
  failed: "失败：某种交错使它不成立。",
  lost: "parts 为 12，应为 15",
  afterStep2: "第 2 步之后",
  check: "检查",
  solved: "完成。已证明在每种交错下都成立。",
  progress: "已完成 1 / 14",
};

const widths = [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
];
const languages = [
  { locale: "en-US", words: english },
  { locale: "zh-CN", words: chinese },
];

for (const viewport of widths) {
  for (const { locale, words: t } of languages) {
    test.describe(`${viewport.width} pixels, ${locale}`, () => {
      test.use({ viewport, locale });

      test("a wrong program is mended, measured, explored, and solves its task", async ({
        page,
      }) => {
        const button = (name: string | RegExp) =>
          page.getByRole("button", { name, exact: typeof name === "string" });
        // Phones show one panel at a time.
        const look = async (panel: keyof Words["panels"]) => {
          if (viewport.width < 761) {
            await page.locator(".switcher").getByRole("button", { name: t.panels[panel] }).click();
          }
        };

        await test.step("a wrong program has a caret, and is fixed", async () => {
          await open(page, "#lesson=first-axis");
          await look("program");
          const start = await text(page);
          await write(
            page,
            faster(start).replace("return mask;", "GT_Update(mask)\n  return mask;"),
          );
          const problems = page.getByRole("region", { name: t.problems });
          await expect(problems.locator("pre")).toContainText("^");
          await problems.getByRole("button", { name: t.fix }).click();
          await expect(problems).toContainText(t.none);
          expect(await text(page)).toContain("GT_Update(mask);");
        });

        await test.step("it runs, and the scope measures it", async () => {
          await atMaximum(page);
          await button(t.run).click();
          await expect(status(page)).toHaveText(t.finished);
          await look("scope");
          await page.getByRole("checkbox", { name: t.cursors }).check();
          await page.getByLabel(t.cursorA).fill("600");
          await page.getByLabel(t.cursorB).fill("1300");
          // 200 ms up to 50 pulse/ms, 800 ms there, 200 ms down.
          const readings = page.locator('tr[data-channel="axis1.prfVel"] td');
          await expect(readings).toHaveText(["50", "0", "-50", "-0.071"]);
          await expectFits(page);
        });

        await test.step("it is stepped back", async () => {
          await look("timeline");
          const moment = page.getByText(t.moment);
          const end = (await moment.textContent()) ?? "";
          await button(t.back).click();
          await expect(moment).not.toHaveText(end);
        });

        await test.step("an exploration shows the order that breaks it", async () => {
          await page.evaluate(() => {
            location.hash = "#lesson=lost-update";
          });
          await expect(page.locator("#lesson")).toContainText("money = money + deposit;");
          await button(t.explore).click();
          await expect(page.locator("#interleaving h3")).toHaveText(t.lost);
          const step = page.locator("#step-2");
          await step.click();
          await expect(step).toHaveAttribute("aria-selected", "true");
          await look("timeline");
          await expect(page.locator(".now-pill")).toHaveText(t.afterStep2);
          await look("lesson");
          await expect(page.locator(".verdict")).toContainText(t.failed);
          await expectFits(page);
        });

        await test.step("the task is solved", async () => {
          await look("program");
          const start = await text(page);
          await write(
            page,
            start.replace(/ {2}copy = parts;[^]*parts = copy;/, "  parts = parts + 1;"),
          );
          await look("lesson");
          await button(t.check).click();
          await expect(page.locator(".verdict")).toContainText(t.solved);
          await expect(page.getByText(t.progress)).toBeVisible();
          await expect(page.locator("#interleaving")).toHaveCount(0);
          await expectFits(page);
          await expectAccessible(page);
        });
      });
    });
  }
}

function faster(program: string): string {
  return program.replaceAll("= 0.125;", "= 0.25;");
}

/** Nothing is cut off at the right. */
async function expectFits(page: Page): Promise<void> {
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(wide).toBeLessThanOrEqual(0);
}
