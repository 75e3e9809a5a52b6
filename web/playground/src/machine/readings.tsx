// What an axis says of itself in words and numbers: its states, its position and its velocity.

import type { MachineWords } from "../texts/machine.js";
import { number } from "../texts/number.js";
import { type AxisView, type Drive, positionNumber, positionText } from "./axes.js";

/** A state in words with its tone. */
type State = [text: string, tone: string];

/** Abbreviations that CiA 402 gives to the numbers of modes. */
const driveModes: Record<number, string | undefined> = {
  1: "PP",
  3: "PV",
  4: "PT",
  6: "HM",
  8: "CSP",
  9: "CSV",
  10: "CST",
};

/** Operation is enabled, a quick stop, the reaction to a fault, a fault. */
const driveTones: Record<number, string | undefined> = { 4: "good", 5: "bad", 6: "bad", 7: "bad" };

/** From the least to the most important one. */
export function statesOf(axis: AxisView, words: MachineWords): State[] {
  const { drive } = axis;
  const bad: [boolean, string][] = [
    [axis.alarm, words.alarm],
    [axis.followingError, words.followingError],
    [axis.positiveLimit, words.positiveOn],
    [axis.negativeLimit, words.negativeOn],
  ];
  return [
    [axis.servoOn ? words.servo : words.off, axis.servoOn ? "good" : ""],
    ...(drive ? [driveState(drive, words)] : []),
    ...(axis.moving ? [[words.moving, "now"] satisfies State] : []),
    ...bad.flatMap(([is, text]) => (is ? [[text, "bad"] satisfies State] : [])),
  ];
}

/** A drive on the bus: its state, and in which mode it works. */
function driveState({ state, mode }: Drive, words: MachineWords): State {
  const text = words.driveStates[state] ?? String(state);
  const name = driveModes[mode];
  return [name ? `${text}, ${name}` : text, driveTones[state] ?? ""];
}

export function Readings({ axis }: { axis: AxisView }) {
  return (
    <>
      <output class="reading" data-axis={axis.axis}>
        {positionNumber(axis)}
        <small> {axis.positionUnit}</small>
      </output>
      <output class="reading">
        {number(axis.velocity, 2)}
        <small> {axis.velocityUnit}</small>
      </output>
    </>
  );
}

export function States({ axis, words }: { axis: AxisView; words: MachineWords }) {
  return (
    <>
      {statesOf(axis, words).map(([text, tone]) => (
        <span key={text} class={`tag ${tone}`}>
          {text}
        </span>
      ))}
    </>
  );
}

/** Its name, states and readings in a line. */
export function AxisHead({ axis, words }: { axis: AxisView; words: MachineWords }) {
  return (
    <div class="row">
      <strong>{words.axis(axis.axis)}</strong>
      <States axis={axis} words={words} />
      <span class="grow" />
      <Readings axis={axis} />
    </div>
  );
}

export function labelOf(axis: AxisView, words: MachineWords): string {
  const velocity = `${number(axis.velocity, 2)} ${axis.velocityUnit}`;
  return words.stage(axis.axis, positionText(axis), velocity);
}

/** An axis has the colour of the channel at its place. */
export function colourOf(axis: number): string {
  return `a${(axis - 1) % 8}`;
}
