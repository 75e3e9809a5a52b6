// The pins of a word: outputs are lamps, inputs are switches that can be clicked.

import type { CardWord } from "@oncard/engine";

import type { MachineWords } from "../texts/machine.js";

/** Gives an input another level; pins count from 1. */
export type SetInput = (word: string, pin: number, level: number) => void;

interface PinsProps {
  word: CardWord;
  pins: number;
  words: MachineWords;
  onInput: SetInput;
}

export function Pins({ word, pins, words, onInput }: PinsProps) {
  const numbers = Array.from({ length: pins }, (_, index) => index + 1);
  const level = (pin: number) => (word.value >> (pin - 1)) & 1;
  return (
    <div class="pins">
      {numbers.map((pin) =>
        word.kind === "output" ? (
          <span
            key={pin}
            class={`pin lamp ${level(pin) ? "on" : ""}`}
            role="img"
            aria-label={words.output(pin, level(pin))}
          >
            {pin}
          </span>
        ) : (
          <button
            key={pin}
            type="button"
            class="pin"
            aria-pressed={level(pin) === 1}
            aria-label={words.input(word.name, pin)}
            onClick={() => {
              onInput(word.name, pin, 1 - level(pin));
            }}
          >
            {pin}
          </button>
        ),
      )}
    </div>
  );
}
