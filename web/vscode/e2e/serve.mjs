// Visual Studio Code for browsers with the packed extension, for the tests.
//   node serve.mjs VSIX PORT FOLDER    installs and serves; FOLDER, which is emptied first, has what
//                                      the editor keeps, and in `work`, `lost` and `star` the folders that
//                                      it opens
// Its server is that of code-server. Two of its native modules have substitutes: nothing is built.

import { spawn, spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { delimiter, dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const [vsix, port, folder] = process.argv.slice(2);
const samples = fileURLToPath(new URL("../../../samples", import.meta.url));
const modules = fileURLToPath(new URL("node_modules", import.meta.url));
const editor = join(modules, "code-server/lib/vscode");
const kept = resolve(folder);

/** Without these, the host of the extensions would report errors without end. */
const substitutes = {
  // Output channels are files that this writes.
  "@vscode/spdlog": `
    const { appendFileSync, mkdirSync } = require("node:fs");
    const { dirname } = require("node:path");
    exports.setFlushOn = exports.setLevel = () => undefined;
    exports.createRotatingLogger = exports.createAsyncRotatingLogger = async (_, file) => {
      mkdirSync(dirname(file), { recursive: true });
      let end = "\\n";
      const write = (text) => appendFileSync(file, text + end);
      const ignore = () => undefined;
      return {
        trace: write, debug: write, info: write, warn: write, error: write, critical: write,
        setLevel: ignore, setPattern: ignore, flush: ignore, drop: ignore,
        clearFormatters: () => { end = ""; },
      };
    };`,
  "native-watchdog": "exports.start = () => undefined;",
};
for (const [name, text] of Object.entries(substitutes)) {
  mkdirSync(join(modules, name), { recursive: true });
  writeFileSync(join(modules, name, "index.js"), text);
}
// The editor searches for files with ripgrep. Its package would fetch the program when it is installed;
// that of the system does as well.
const search = join(modules, "@vscode/ripgrep/bin/rg");
const found = (process.env["PATH"] ?? "")
  .split(delimiter)
  .map((path) => join(path, "rg"))
  .find((path) => existsSync(path));
if (found && !existsSync(search)) {
  mkdirSync(dirname(search), { recursive: true });
  symlinkSync(found, search);
}
// The pages of the editor look for their modules in its own folder.
if (!existsSync(join(editor, "node_modules"))) symlinkSync(modules, join(editor, "node_modules"));

rmSync(kept, { recursive: true, force: true });
cpSync(join(samples, "01_sum"), join(kept, "work"), { recursive: true });
cpSync(join(samples, "02_loops/structured.c"), join(kept, "work/structured.c"));
cpSync(join(samples, "26_lost_update"), join(kept, "lost"), { recursive: true });
cpSync(join(samples, "53_star"), join(kept, "star"), { recursive: true });
const settings = { "security.workspace.trust.enabled": false, "workbench.startupEditor": "none" };
mkdirSync(join(kept, "data/User"), { recursive: true });
writeFileSync(join(kept, "data/User/settings.json"), JSON.stringify(settings));

const server = [
  join(editor, "out/server-main.js"),
  ...["--server-data-dir", join(kept, "server"), "--user-data-dir", join(kept, "data")],
  ...["--extensions-dir", join(kept, "extensions"), "--force-disable-user-env"],
];
// As on a computer without the command.
const env = { ...process.env, PATH: "/nowhere" };

const installed = spawnSync(
  process.execPath,
  [...server, "--install-extension", resolve(vsix), "--accept-server-license-terms"],
  { env, encoding: "utf8" },
);
if (installed.status !== 0) throw new Error(installed.stderr);
const served = spawn(
  process.execPath,
  [
    ...[...server, "--host", "127.0.0.1", "--port", port, "--without-connection-token"],
    ...["--accept-server-license-terms", "--telemetry-level", "off"],
  ],
  { env, stdio: "ignore" },
);
for (const signal of ["SIGINT", "SIGTERM"]) process.on(signal, () => served.kill());
served.on("exit", (code) => process.exit(code ?? 0));
