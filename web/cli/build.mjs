// Bundles the command and packs it: everything that it needs is inside.
//   node build.mjs MODULE FULL FOLDER   makes FOLDER/oncard-VERSION.tgz from the compiled packages,
//                                       oncard-cli.wasm and oncard-full.wasm
// Prints the name of the file. Tested by test/package.test.ts.

import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { build } from "esbuild";

import { noticesOf } from "../vscode/notices.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const top = resolve(here, "../..");
const [module, full, target] = process.argv.slice(2).map((path) => resolve(path));
const stage = join(target, "package");

rmSync(stage, { recursive: true, force: true });
mkdirSync(stage, { recursive: true });

const { metafile } = await build({
  absWorkingDir: here,
  entryPoints: ["src/oncard.ts"],
  outfile: join(stage, "oncard.mjs"),
  bundle: true,
  minify: true,
  platform: "node",
  format: "esm",
  target: "node18",
  // ES modules before those for require(): the latter load their parts by computed names.
  mainFields: ["module", "main"],
  // Some parts ask require() for Node's own modules.
  banner: {
    js: 'import { createRequire } from "node:module"; const require = createRequire(import.meta.url);',
  },
  legalComments: "none",
  metafile: true,
  logLevel: "warning",
});

copyFileSync(module, join(stage, "oncard-cli.wasm"));
// The servers for editors also explore, and read records of hosts.
copyFileSync(full, join(stage, "oncard.wasm"));
copyFileSync(join(here, "README.md"), join(stage, "README.md"));
copyFileSync(join(top, "LICENSE"), join(stage, "LICENSE"));
writeFileSync(join(stage, "ThirdPartyNotices.txt"), noticesOf(here, metafile, ["libcli11-dev"]));

const { version, description, license, keywords } = JSON.parse(
  readFileSync(join(here, "package.json"), "utf8"),
);
const manifest = {
  name: "oncard",
  version,
  description,
  license,
  keywords,
  type: "module",
  bin: { oncard: "oncard.mjs" },
  engines: { node: ">=18.18" },
};
writeFileSync(join(stage, "package.json"), `${JSON.stringify(manifest, undefined, 2)}\n`);

// npm is a script of Node, wherever it is installed; on Windows only a shell finds it.
const npm = process.env.npm_execpath;
const [command, ...first] = npm === undefined ? ["npm"] : [process.execPath, npm];
const pack = ["pack", "--silent", "--ignore-scripts", "--pack-destination", target];
process.stdout.write(execFileSync(command, [...first, ...pack], { cwd: stage, encoding: "utf8" }));
