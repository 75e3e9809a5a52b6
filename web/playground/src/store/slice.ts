// The state of the page is in slices. Everybody can read a slice, and is drawn or called again when
// what was read has changed; only the module that made it can change it.
// Tested by test/slice.test.ts.

import { batch, type ReadonlySignal, type Signal, signal } from "@preact/signals";

export type Slice<State> = { readonly [Key in keyof State]: ReadonlySignal<State[Key]> };

/** Changes some parts of a slice at once: whoever reads several of them sees all or none changed. */
export type Change<State> = (change: Partial<State>) => void;

/** A slice, and what changes it, which its module keeps for itself. */
export function slice<State extends object>(initial: State): [Slice<State>, Change<State>] {
  const signals = Object.fromEntries(
    Object.entries(initial).map(([key, value]) => [key, signal<unknown>(value)]),
  ) as { [Key in keyof State]: Signal<State[Key]> };
  const change: Change<State> = (parts) => {
    batch(() => {
      for (const key of Object.keys(parts) as (keyof State)[]) {
        signals[key].value = parts[key] as State[keyof State];
      }
    });
  };
  return [signals, change];
}
