// Channels that can only be 0 or 1: flags of the card, and pins of its words. What a channel is decides
// that, not the values that it happens to have.
// Tested by test/digital.test.ts.

import type { Card, CardWord, Variable } from "@oncard/engine";

/** Variables hide words and values of the card that have their names. */
function isHidden(name: string, variables: Variable[]): boolean {
  return variables.some(({ path }) => path === name);
}

/** The name of a pin, which counts from 1. */
export function pinName(word: string, pin: number): string {
  return `${word}[${pin}]`;
}

/** The pins of all words, from 1 on: `gpo[1]`. */
export function pinNames(card: Card | undefined, variables: Variable[]): string[] {
  return (card?.words ?? [])
    .filter(({ name }) => !isHidden(name, variables))
    .flatMap(({ name, pins }) =>
      Array.from({ length: pins }, (_, index) => pinName(name, index + 1)),
    );
}

/** The word of a pin, and its bit from 0 on. */
function pinOf(
  name: string,
  card: Card | undefined,
  variables: Variable[],
): { word: CardWord; bit: number } | undefined {
  const [, wordName = "", pin] = /^(\w+)\[(\d+)\]$/.exec(name) ?? [];
  const word = card?.words.find((each) => each.name === wordName);
  if (!word || isHidden(wordName, variables)) return undefined;
  return { word, bit: Number(pin) - 1 };
}

/** The present level of a pin; undefined for other names. */
export function levelOfPin(
  name: string,
  card: Card | undefined,
  variables: Variable[],
): number | undefined {
  const pin = pinOf(name, card, variables);
  return pin && (pin.word.value >> pin.bit) & 1;
}

export function isDigital(name: string, card: Card | undefined, variables: Variable[]): boolean {
  if (isHidden(name, variables)) return false;
  if (pinOf(name, card, variables)) return true;
  return (card?.parts ?? []).some(({ values }) =>
    values.some(({ path, flag = false }) => flag && path === name),
  );
}
