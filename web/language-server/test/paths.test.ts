import { expect, test } from "vitest";

import { beside, normal, pathOf, uriOf } from "../src/paths.js";

test.each([
  ["file:///home/a/p.c", "/home/a/p.c"],
  ["file:///home/a%20b/%E7%BA%BF.c", "/home/a b/线.c"],
  ["file:///c%3A/b/p.c", "c:/b/p.c"],
])("%s is %s", (uri, path) => {
  expect(pathOf(uri)).toBe(path);
  expect(uriOf(path)).toBe(uri);
});

test.each([
  ["/a/s.toml", "p.c", "/a/p.c"],
  ["/a/b/s.toml", "../p.c", "/a/p.c"],
  ["c:/a/s.toml", "..\\p.c", "c:/p.c"],
  ["/a/s.toml", "/b/./p.c", "/b/p.c"],
  ["/a/s.toml", "d:/p.c", "d:/p.c"],
])("beside %s, %s is %s", (file, path, result) => {
  expect(beside(file, path)).toBe(result);
  expect(normal(result)).toBe(result);
});
