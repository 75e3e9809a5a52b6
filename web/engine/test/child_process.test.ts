import { expect, test } from "vitest";

import { oncard, startEngine } from "./support.js";

test("a program that does not exist", async () => {
  await expect(startEngine("/nowhere/oncard").hello()).rejects.toThrow(
    "cannot start '/nowhere/oncard': there is no such program",
  );
});

test("a program that ends at once", async () => {
  const engine = startEngine("false");
  await expect(engine.hello()).rejects.toThrow("'false' has ended with exit code 1");
  await expect(engine.state()).rejects.toThrow("'false' has ended with exit code 1");
});

test("a program that complains", async () => {
  // `ls debug --stdio` knows no such option.
  await expect(startEngine("ls").hello()).rejects.toThrow(
    /'ls' has ended with exit code 2: .*--stdio/s,
  );
});

test("a program that is something else", async () => {
  await expect(startEngine("echo").hello()).rejects.toThrow(
    "this is not an answer of the session protocol: debug --stdio",
  );
});

test("lines of Unicode that look like the end of a line do not end one", async () => {
  const text = "// \u2028 \u2029 \u0085\nint f()\n{\n}\n";
  const loaded = await startEngine(oncard).load({ main: "p.c", files: { "p.c": text } });
  expect(loaded).toMatchObject({ files: [{ text }] });
});
