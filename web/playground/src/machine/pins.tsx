// The pins of a word: outputs are lamps, inputs are switches that can be clicked.

import type { CardWord } from "@oncard/engine";

import { bench } from "../session/bench.js";
import { texts } from "../texts/texts.js";

export function Pins({ word, pins }: { word: CardWord; pins: number }) {
  const { machine: t } = texts.value;
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
            aria-label={t.output(pin, level(pin))}
          >
            {pin}
          </span>
        ) : (
          <button
            key={pin}
            type="button"
            class="pin"
            aria-pressed={level(pin) === 1}
            aria-label={t.input(word.name, pin)}
            onClick={() => void bench.setInput(word.name, pin, 1 - level(pin))}
          >
            {pin}
          </button>
        ),
      )}
    </div>
  );
}
