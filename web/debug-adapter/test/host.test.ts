import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";

import { expect, test } from "vitest";

import { folderOf, oncard, openEditor, sample } from "./support.js";

/** What a host is compiled with: `build/`, of which `oncard` is in `bin/`. */
const build = dirname(dirname(oncard));
const withoutLibrary = !existsSync(join(build, "lib/libgts.so"));

/** A folder with the host of a sample and its program. */
function hostFolder(): string {
  const folder = folderOf({ "sum.c": readFileSync(sample("01_sum/sum.c"), "utf8") });
  const options = ["-I", join(build, "include"), "-L", join(build, "lib"), "-lgts"];
  const source = sample("01_sum/host.cpp");
  const { status, stderr } = spawnSync("c++", [source, ...options, "-o", join(folder, "host")]);
  expect(status, stderr.toString()).toBe(0);
  return folder;
}

/** The editor's id of the host. */
const host = 33;

test.skipIf(withoutLibrary)("a host is walked through, call by call, and its program", async () => {
  const folder = hostFolder();
  const editor = await openEditor();
  await editor.initialize();
  await Promise.all([
    editor.client.waitForEvent("initialized"),
    editor.client.attachRequest({
      host: "./host",
      cwd: folder,
      stopOnEntry: true,
    } as unknown as Parameters<typeof editor.client.attachRequest>[0]),
  ]);
  expect(editor.output).toContain("sum = 5050");
  const { breakpoints } = await editor.request<{ breakpoints: { line: number }[] }>(
    "setBreakpoints",
    {
      source: { path: join(folder, "sum.c") },
      breakpoints: [{ line: 17, condition: "sum > 100" }],
    },
  );
  expect(breakpoints).toMatchObject([{ verified: true, line: 17 }]);
  await editor.client.configurationDoneRequest();
  expect((await editor.stopped()).threadId).toBe(host);
  const next = async () => {
    const { stackFrames } = await editor.request<{ stackFrames: { name: string }[] }>(
      "stackTrace",
      { threadId: host },
    );
    return stackFrames[0]?.name;
  };
  expect(await next()).toBe('GT_Compile("sum.c", pWrongInfo)');
  await editor.move("next", host - 1);
  expect(await next()).toBe('GT_Download("sum.bin")');
  await editor.move("continue", host - 1);
  // 1 + ... + 14 is the first sum above 100.
  expect(await editor.value("sum")).toBe("105");
  expect(await editor.line(0)).toBe(17);
  await editor.move("reverseContinue", host - 1);
  expect(await next()).toBe('GT_Compile("sum.c", pWrongInfo)');
});

test("a host that cannot be run is not attached to", async () => {
  const editor = await openEditor();
  await editor.initialize();
  const args = { host: "./there_is_none" };
  await expect(editor.request("attach", args)).rejects.toThrow(/the host was not run/);
});
