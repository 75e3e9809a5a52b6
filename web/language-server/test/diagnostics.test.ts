import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Diagnostic } from "vscode-languageserver";

import type { Findings } from "../src/checker.js";
import { Diagnostics, pauseMs } from "../src/diagnostics.js";
import { uriOf } from "../src/paths.js";

const a = uriOf("/a.c");
const b = uriOf("/b.c");
const start = { line: 0, character: 0 };
const saying = (message: string): Diagnostic => ({ message, range: { start, end: start } });

/** Diagnostics with checks that a test ends when it wants. */
function controlled() {
  const ends: ((findings: Findings | undefined) => void)[] = [];
  const shown: string[] = [];
  const diagnostics = new Diagnostics(
    () =>
      new Promise((resolve) => {
        ends.push(resolve);
      }),
    (uri, list) => shown.push(`${uri} ${list.map(({ message }) => message).join()}`),
  );
  return { diagnostics, ends, shown };
}

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

test("a check waits until the user pauses", () => {
  const { diagnostics, ends } = controlled();
  diagnostics.changed(a);
  vi.advanceTimersByTime(pauseMs - 1);
  diagnostics.changed(a);
  vi.advanceTimersByTime(pauseMs - 1);
  expect(ends).toHaveLength(0);
  vi.advanceTimersByTime(1);
  expect(ends).toHaveLength(1);
});

test("a check that is overtaken shows nothing", async () => {
  const { diagnostics, ends, shown } = controlled();
  const first = diagnostics.checkNow(a);
  const second = diagnostics.checkNow(a);
  ends[1]?.(new Map([["/a.c", [saying("new")]]]));
  await second;
  ends[0]?.(new Map([["/a.c", [saying("old")]]]));
  await first;
  expect(shown).toEqual([`${a} new`]);
});

test("what is no longer found disappears, also in other files", async () => {
  const { diagnostics, ends, shown } = controlled();
  const first = diagnostics.checkNow(a);
  ends[0]?.(
    new Map([
      ["/a.c", []],
      ["/h.h", [saying("x")]],
    ]),
  );
  await first;
  const second = diagnostics.checkNow(a);
  ends[1]?.(new Map([["/a.c", []]]));
  await second;
  expect(shown).toEqual([`${a} `, `${uriOf("/h.h")} x`, `${a} `, `${uriOf("/h.h")} `]);
});

test("what two documents say about a file is shown once", async () => {
  const { diagnostics, ends } = controlled();
  const both = [diagnostics.checkNow(a), diagnostics.checkNow(b)];
  ends[0]?.(new Map([["/h.h", [saying("x")]]]));
  ends[1]?.(new Map([["/h.h", [saying("x"), saying("y")]]]));
  await Promise.all(both);
  expect(diagnostics.shown(uriOf("/h.h"))).toEqual([saying("x"), saying("y")]);
  diagnostics.closed(b);
  expect(diagnostics.shown(uriOf("/h.h"))).toEqual([saying("x")]);
});

test("a check that ends after its document was closed shows nothing", async () => {
  const { diagnostics, ends, shown } = controlled();
  const check = diagnostics.checkNow(a);
  diagnostics.closed(a);
  ends[0]?.(new Map([["/a.c", [saying("late")]]]));
  await check;
  expect(shown).toEqual([]);
});
