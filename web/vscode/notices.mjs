// The licences of what was bundled. Tested by test/package.test.ts.

import { readdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";

/** Debian packages whose code is in the modules. */
const inModule = [
  "libc++-19-dev-wasm32",
  "libclang-rt-19-dev-wasm32",
  "libeigen3-dev",
  "libfast-float-dev",
  "libfmt-dev",
  "libtomlplusplus-dev",
  "libxxhash-dev",
  "nlohmann-json3-dev",
  "wasi-libc",
];

/**
 * @param folder to which the paths of the metafile are relative
 * @param metafile of esbuild
 * @param more Debian packages whose code is in the modules, too
 * @returns one text with the licence of each package of others; it throws where one has none
 */
export function noticesOf(folder, metafile, more = []) {
  const packages = new Map();
  for (const input of Object.keys(metafile.inputs)) {
    const found = /^(.*\/node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(input)?.[1];
    if (found !== undefined) packages.set(resolve(folder, found), undefined);
  }
  const texts = [...packages.keys()].sort().map((path) => {
    const { name, version, license } = JSON.parse(readFileSync(join(path, "package.json"), "utf8"));
    const file = readdirSync(path).find((each) => /^(?:licen[cs]e|copying)/i.test(each));
    if (file === undefined) throw new Error(`${name} has no file with its licence`);
    const text = readFileSync(join(path, file), "utf8").replaceAll("\r\n", "\n").trim();
    return `${name} ${version} (${license})\n\n${text}\n`;
  });
  for (const name of [...inModule, ...more].sort()) {
    const text = readFileSync(`/usr/share/doc/${name}/copyright`, "utf8").trim();
    texts.push(`${name} (in the WebAssembly module)\n\n${text}\n`);
  }
  return texts.join(`\n${"-".repeat(80)}\n\n`);
}
