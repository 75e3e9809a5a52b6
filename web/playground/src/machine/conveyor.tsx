// A conveyor from the side: parts on a belt that its axis moves, as far as the axis goes.

import type { MachineWords } from "../texts/machine.js";
import { type AxisView, firstReach, placeOn } from "./axes.js";
import { AxisHead, colourOf, labelOf } from "./readings.js";

const width = 560;
const left = 32;
const right = width - 32;
const belt = { top: 40, height: 20 };
const part = { width: 40, height: 26 };
/** Parts and cleats lie so far from each other. */
const partGap = (right - left) / 4;
const cleatGap = (right - left) / 32;

/** Where things are on the belt that repeat at a distance, when it has gone so far. */
export function placesOnBelt(gone: number, gap: number, length: number): number[] {
  const first = gone - Math.floor(gone / gap) * gap;
  const count = Math.ceil((length - first) / gap);
  return Array.from({ length: count }, (_, index) => first + index * gap);
}

export function Conveyor({ axis, words }: { axis: AxisView; words: MachineWords }) {
  const gone = placeOn(firstReach(axis.positionUnit), axis.actual) * (right - left);
  const onBelt = (gap: number, length: number) =>
    placesOnBelt(gone, gap, length).map((place) => left + place);
  return (
    <div class={`stage ${colourOf(axis.axis)}`}>
      <AxisHead axis={axis} words={words} />
      <svg viewBox={`0 0 ${width} 68`} role="img" aria-label={labelOf(axis, words)} class="rail">
        {onBelt(partGap, right - left - part.width).map((at, index) => (
          <rect
            key={index}
            x={at}
            y={belt.top - part.height}
            width={part.width}
            height={part.height}
            rx="3"
            class="carriage"
          />
        ))}
        <rect
          x={left - 20}
          y={belt.top}
          width={right - left + 40}
          height={belt.height}
          rx={belt.height / 2}
          class="belt"
        />
        {onBelt(cleatGap, right - left).map((x, index) => (
          <path key={index} d={`M${x} ${belt.top}v5`} class="cleat" />
        ))}
        {[left - 10, right + 10].map((x) => (
          <circle key={x} cx={x} cy={belt.top + belt.height / 2} r="6" class="motor" />
        ))}
      </svg>
    </div>
  );
}
