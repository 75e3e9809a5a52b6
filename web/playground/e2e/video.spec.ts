// The picture and the video of a run, which the dialog for sharing has.

import { readFile } from "node:fs/promises";

import { expect, type Locator, type Page, test } from "@playwright/test";

import { expectAccessible, open, openOwn, runToEnd } from "./support.js";

/** Runs two axes, one after the other, for 2.5 s; the video then takes 3.6 s. */
async function run(page: Page): Promise<void> {
  await open(page);
  await openOwn(page);
  await runToEnd(page);
}

async function share(page: Page): Promise<Locator> {
  await page.getByRole("button", { name: "Share" }).click();
  return page.getByRole("region", { name: "Picture and video" });
}

async function saved(page: Page, button: Locator): Promise<{ name: string; content: Buffer }> {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return { name: download.suggestedFilename(), content: await readFile(await download.path()) };
}

/** How many pixels differ much between two times of a video, in s. */
function changed(video: Locator, times: [number, number]): Promise<number> {
  return video.evaluate(async (element, [before, after]) => {
    if (!(element instanceof HTMLVideoElement)) throw new Error("no video");
    element.pause();
    const pixelsAt = async (time: number) => {
      element.currentTime = time;
      // An event may still be that of a seek before, as of the loop.
      do {
        await new Promise((resume) => {
          element.addEventListener("seeked", resume, { once: true });
        });
      } while (element.seeking);
      const canvas = document.createElement("canvas");
      canvas.width = element.videoWidth;
      canvas.height = element.videoHeight;
      const context = canvas.getContext("2d");
      if (!context) throw new Error("no context");
      context.drawImage(element, 0, 0);
      return context.getImageData(0, 0, canvas.width, canvas.height).data;
    };
    const one = await pixelsAt(before);
    const other = await pixelsAt(after);
    let count = 0;
    for (let at = 0; at < one.length; at += 4) {
      if (Math.abs((one[at] ?? 0) - (other[at] ?? 0)) > 64) count += 1;
    }
    return count;
  }, times);
}

test("a run becomes a video that plays, and stays where it is", async ({ page }) => {
  await run(page);
  const moment = await page.locator(".clock-moment").textContent();
  const part = await share(page);
  await expect(part).toContainText("Recording takes 3.6 s.");
  await part.getByRole("button", { name: "Record a video" }).click();
  await expect(part.getByRole("progressbar", { name: "Recording" })).toBeVisible();
  const video = part.locator("video");
  await expect(video).toBeVisible();
  await expect(video).toHaveJSProperty("paused", false);
  await expect(video).toHaveJSProperty("loop", true);
  await expect(video).toHaveJSProperty("videoWidth", 1280);
  await expect(video).toHaveJSProperty("videoHeight", 720);
  const seconds = await video.evaluate((element) => (element as HTMLVideoElement).duration);
  // A busy browser may lose some of its start.
  expect(seconds).toBeGreaterThan(2.3);
  expect(seconds).toBeLessThan(6);
  // The carriage alone has 44 * 28 pixels, the line of now 6 * 194.
  expect(await changed(video, [0, seconds - 0.1])).toBeGreaterThan(2000);
  await expectAccessible(page);
  const { name, content } = await saved(page, part.getByRole("button", { name: "Save the video" }));
  expect(name).toBe("oncard.webm");
  expect(content.subarray(0, 4).toString("hex")).toBe("1a45dfa3");
  expect(content.length).toBeGreaterThan(20_000);
  await page.keyboard.press("Escape");
  expect(await page.locator(".clock-moment").textContent()).toBe(moment);
});

test("a recording that is cancelled leaves nothing", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.addInitScript(() => {
    const streams: MediaStream[] = [];
    Object.assign(globalThis, { streams });
    const { prototype } = HTMLCanvasElement;
    // eslint-disable-next-line @typescript-eslint/unbound-method
    const { captureStream } = prototype;
    prototype.captureStream = function (...rates) {
      const stream = captureStream.apply(this, rates);
      streams.push(stream);
      return stream;
    };
  });
  const tracks = () =>
    page.evaluate(() => {
      const { streams } = globalThis as unknown as { streams: MediaStream[] };
      return streams.flatMap((each) => each.getTracks().map(({ readyState }) => readyState));
    });
  await run(page);
  const part = await share(page);
  const record = part.getByRole("button", { name: "Record a video" });
  await record.press("Enter");
  const cancel = part.getByRole("button", { name: "Cancel" });
  await expect(cancel).toBeFocused();
  await cancel.press("Enter");
  await expect(record).toBeFocused();
  await expect(part.locator("video")).toHaveCount(0);
  await expect.poll(tracks).toEqual(["ended"]);

  await record.press("Enter");
  await expect(cancel).toBeFocused();
  await page.keyboard.press("Escape");
  await expect(page.getByRole("dialog")).toHaveCount(0);
  await expect.poll(tracks).toEqual(["ended", "ended"]);

  // One that is not cancelled shows its video; whoever prefers no motion begins it.
  await share(page);
  await record.click();
  const video = part.locator("video");
  await expect(video).toHaveJSProperty("controls", true);
  await expect(video).toHaveJSProperty("paused", true);
  await expect.poll(tracks).toEqual(["ended", "ended", "ended"]);
});

test("the picture has the same size whatever the screen, and can be copied", async ({
  browser,
}) => {
  const context = await browser.newContext({
    deviceScaleFactor: 2,
    permissions: ["clipboard-read", "clipboard-write"],
  });
  const page = await context.newPage();
  await run(page);
  const part = await share(page);
  await expect(part.getByRole("img", { name: "Machine and scope at 2500 ms" })).toBeVisible();
  const { name, content } = await saved(
    page,
    part.getByRole("button", { name: "Save the picture" }),
  );
  expect(name).toBe("oncard.png");
  expect(content.subarray(1, 4).toString()).toBe("PNG");
  // Width and height stand in the first part of the file.
  expect([content.readUInt32BE(16), content.readUInt32BE(20)]).toEqual([1280, 720]);
  await part.getByRole("button", { name: "Copy the picture" }).click();
  await expect(part.getByText("Copied.")).toBeVisible();
  const types = await page.evaluate(async () =>
    (await navigator.clipboard.read()).flatMap((item) => item.types),
  );
  expect(types).toEqual(["image/png"]);
  await context.close();
});

test("before a run there is nothing to show", async ({ page }) => {
  await open(page);
  await openOwn(page);
  const part = await share(page);
  for (const name of ["Record a video", "Save the picture"]) {
    const button = part.getByRole("button", { name });
    await expect(button).toBeDisabled();
    await expect(button).toHaveAccessibleDescription(/run the program first/);
  }
  await expectAccessible(page);
});

test("a browser that cannot record says so", async ({ page }) => {
  await page.addInitScript(() => {
    Reflect.deleteProperty(globalThis, "MediaRecorder");
  });
  await run(page);
  const record = (await share(page)).getByRole("button", { name: "Record a video" });
  await expect(record).toBeDisabled();
  await expect(record).toHaveAccessibleDescription("This browser cannot record videos.");
});
