// Documents of an editor as files of the engine. The engine's paths have slashes on every system.
// Tested by test/paths.test.ts.

import { posix } from "node:path";

import { URI } from "vscode-uri";

export function pathOf(uri: string): string {
  // `c:/folder` on Windows, as the module has no other separator.
  return URI.parse(uri).path.replace(/^\/([A-Za-z]:)/, "$1");
}

export function uriOf(path: string): string {
  return URI.from({ scheme: "file", path: path.startsWith("/") ? path : `/${path}` }).toString();
}

/** A path without `.` and `..`. */
export function normal(path: string): string {
  return posix.normalize(path);
}

/** A path that is relative to the folder of a file. */
export function beside(file: string, path: string): string {
  return /^(?:\/|[A-Za-z]:)/.test(path)
    ? normal(path)
    : posix.join(posix.dirname(file), path.replaceAll("\\", "/"));
}
