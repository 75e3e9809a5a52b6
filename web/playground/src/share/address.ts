// What the address of the page says, and what of it others may see.
// Tested by test/address.test.ts.

/** Whether the page comes from `oncard serve`, which has its engine. */
export function hasEngineHere(address: string): boolean {
  return new URL(address).searchParams.get("engine") === "here";
}

/**
 * A link with this fragment. The address of `oncard serve` is a secret and leads nowhere from
 * another computer, so that only the fragment is left of it: any playground takes it.
 * @param address of the page
 * @param fragment begins with `#`
 */
export function linkWith(fragment: string, address: string): string {
  return hasEngineHere(address) ? fragment : new URL(fragment, address).href;
}
