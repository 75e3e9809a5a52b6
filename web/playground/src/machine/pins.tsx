// The pins of words: outputs are lamps, inputs are switches that can be clicked. Those that the scenario
// names have a line each, the others are numbers in a grid.

import type { Card, CardWord, MachineLook } from "@oncard/engine";

import type { MachineWords } from "../texts/machine.js";
import { pin as isSet } from "./axes.js";

/** Gives an input another level; pins count from 1. */
export type SetInput = (word: string, pin: number, level: number) => void;

interface PinsProps {
  word: CardWord;
  words: MachineWords;
  onInput: SetInput;
}

export function Pins({ word, words, onInput }: PinsProps) {
  const numbers = Array.from({ length: word.pins }, (_, index) => index + 1);
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

/** How terminals are marked. */
const marks: Record<string, string | undefined> = { gpo: "DO", gpi: "DI" };

export function terminalOf(type: string, index: number): string {
  return `${marks[type] ?? type} ${index}`;
}

interface NamedPinProps {
  card: Card;
  pin: MachineLook["pins"][number];
  words: MachineWords;
  onInput: SetInput;
}

export function NamedPin({ card, pin: { type, index, name }, words, onInput }: NamedPinProps) {
  const isOn = isSet(card, type, index);
  const place = <small class="muted">{terminalOf(type, index)}</small>;
  if (card.words.find((word) => word.name === type)?.kind === "output") {
    return (
      <div class="named-pin" role="img" aria-label={words.lamp(name, isOn)}>
        <span class={`bulb ${isOn ? "on" : ""}`} />
        <span class="grow">{name}</span>
        {place}
      </div>
    );
  }
  return (
    <button
      type="button"
      class="named-pin"
      role="switch"
      aria-checked={isOn}
      onClick={() => {
        onInput(type, index, isOn ? 0 : 1);
      }}
    >
      <span class="slide" />
      <span class="grow">{name}</span>
      {place}
    </button>
  );
}
