import { expect, test } from "vitest";

import { hasEngineHere, linkWith } from "../src/share/address.js";

const served = "http://127.0.0.1:4000/0123456789abcdef/?engine=here";

test.each([
  [served, true],
  ["http://127.0.0.1:4000/?engine=there", false],
  ["http://127.0.0.1:4000/?here", false],
  ["https://oncard.example/page/#engine=here", false],
])("the engine of %s", (address, isHere) => {
  expect(hasEngineHere(address)).toBe(isHere);
});

test("a link leads to the page that made it", () => {
  expect(linkWith("#p1=abc", "https://oncard.example/page/index.html#old")).toBe(
    "https://oncard.example/page/index.html#p1=abc",
  );
});

test("a link of a page from oncard serve has neither its secret nor its engine", () => {
  expect(linkWith("#p1=abc", served)).toBe("#p1=abc");
  expect(linkWith("#p1=abc", `${served}#lesson=own`)).toBe("#p1=abc");
});
