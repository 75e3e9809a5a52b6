// A rotary table from above: how far its axis has turned it, and a dashed hand where it is commanded to be.

import type { MachineWords } from "../texts/machine.js";
import { number } from "../texts/number.js";
import type { AxisView } from "./axes.js";
import { AxisHead, colourOf, labelOf } from "./readings.js";

const size = 200;
const middle = size / 2;
const radius = 78;
/** A mark every 30 degrees, every third one long. */
const marks = Array.from({ length: 12 }, (_, index) => index * 30);

/** Degrees in a turn, from 0 to 360. */
export function degreesOf(position: number, turn: number): number {
  const part = position / turn;
  return (part - Math.floor(part)) * 360;
}

function at(degrees: number, length: number): string {
  const angle = (degrees * Math.PI) / 180;
  const x = middle + length * Math.sin(angle);
  const y = middle - length * Math.cos(angle);
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}

interface RotaryProps {
  axis: AxisView;
  /** In the unit of the axis. */
  turn: number;
  words: MachineWords;
}

export function Rotary({ axis, turn, words }: RotaryProps) {
  const is = degreesOf(axis.actual, turn);
  const commanded = degreesOf(axis.position, turn);
  return (
    <div class={`stage ${colourOf(axis.axis)}`}>
      <AxisHead axis={axis} words={words} />
      <svg
        viewBox={`0 0 ${size} ${size}`}
        role="img"
        aria-label={labelOf(axis, words)}
        class="rotary"
      >
        <circle cx={middle} cy={middle} r={radius + 12} class="table-frame" />
        <circle cx={middle} cy={middle} r={radius} class="table-bed" />
        {marks.map((mark) => (
          <path
            key={mark}
            d={`M${at(mark, radius)}L${at(mark, radius - (mark % 90 === 0 ? 12 : 6))}`}
            class="rail-tick"
          />
        ))}
        {Math.abs(is - commanded) > 1 && (
          <path d={`M${at(commanded, 12)}L${at(commanded, radius - 14)}`} class="ghost" />
        )}
        <path d={`M${middle} ${middle}L${at(is, radius - 14)}`} class="hand" />
        <circle cx={middle} cy={middle} r="10" class="head" />
        <text x={middle} y={middle + 48} class="rail-text" text-anchor="middle">
          {number(is, 1)}°
        </text>
      </svg>
    </div>
  );
}
