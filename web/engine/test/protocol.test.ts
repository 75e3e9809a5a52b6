import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { expect, onTestFinished, test } from "vitest";

import { oncard, top } from "./support.js";

test("the types of the protocol are those of its schema", () => {
  const folder = mkdtempSync(join(tmpdir(), "oncard-"));
  onTestFinished(() => {
    rmSync(folder, { recursive: true });
  });
  const written = join(folder, "protocol.ts");
  const schema = execFileSync(oncard, ["schema", "--protocol"]);
  const tool = join(top, "web/engine/tools/write_protocol_types.js");
  execFileSync(process.execPath, [tool, written], { input: schema });
  const types = readFileSync(join(top, "web/engine/src/protocol.ts"), "utf8");
  expect(types, "out of date: `npm run protocol` in web/ writes it").toBe(
    readFileSync(written, "utf8"),
  );
});
