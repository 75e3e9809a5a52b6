// A linear stage: motor, screw and rail, and a carriage where the axis is; where it is commanded to be,
// a dashed one if that is elsewhere. Switches stand at their places. Where there are many axes, each
// has a row.

import type { MachineWords } from "../texts/machine.js";
import { number } from "../texts/number.js";
import { type AxisView, placeOn, type Reach, roundUp } from "./axes.js";
import { AxisHead, colourOf, labelOf, Readings, statesOf } from "./readings.js";

const width = 560;
const left = 62;
const right = width - 42;
/** Marks of the scale, every other one with its number. */
const marks = Array.from({ length: 11 }, (_, index) => index / 10);

/** Whether profile and encoder are so far apart that one sees it. */
function isApart(axis: AxisView, reach: Reach): boolean {
  return Math.abs(placeOn(reach, axis.position) - placeOn(reach, axis.actual)) > 0.002;
}

interface AxisProps {
  axis: AxisView;
  reach: Reach;
  words: MachineWords;
}

/** How far the jaws of a gripper are from its middle. */
const jaws = { open: 13, closed: 5 };

/** `gripper`: it carries one, which is open or closed. */
export function Stage(props: AxisProps & { gripper?: "open" | "closed" | undefined }) {
  const { axis, reach, words, gripper } = props;
  const onRail = (position: number) => left + placeOn(reach, position) * (right - left);
  const at = onRail(axis.actual);
  const commanded = onRail(axis.position);
  const fast = Math.abs(axis.velocity);
  const arrow =
    Math.sign(axis.velocity) * (8 + Math.min(1, fast / roundUp(Math.max(100, fast))) * 52);
  return (
    <div class={`stage ${colourOf(axis.axis)}`}>
      <AxisHead axis={axis} words={words} />
      <svg viewBox={`0 0 ${width} 64`} role="img" aria-label={labelOf(axis, words)} class="rail">
        <rect x="2" y="14" width="24" height="24" rx="3" class="motor" />
        <rect x="26" y="21" width="6" height="10" class="rail-bed" />
        <line
          x1="32"
          x2={width - 10}
          y1="26"
          y2="26"
          class="screw"
          stroke-dashoffset={-Math.round((at % 4) * 10) / 10}
        />
        <rect x="32" y="34" width={width - 42} height="8" class="rail-bed" />
        <rect x={width - 10} y="14" width="6" height="30" rx="1" class="rail-bed" />
        {marks.map((part, index) => {
          const x = left + part * (right - left);
          const isLong = index % 2 === 0;
          return (
            <g key={part}>
              <line x1={x} x2={x} y1="45" y2={isLong ? 51 : 48} class="rail-tick" />
              {isLong && (
                <text x={x} y="62" class="rail-text" text-anchor="middle">
                  {number(reach.least + part * (reach.largest - reach.least), 1)}
                </text>
              )}
            </g>
          );
        })}
        {axis.switches.map(({ type, place, on }) => (
          <g key={type} class={`switch ${on ? "on" : ""}`}>
            <title>{words.switches[type] ?? type}</title>
            <line x1={onRail(place)} x2={onRail(place)} y1="12" y2="34" />
            <rect x={onRail(place) - 4} y="4" width="8" height="8" rx="2" />
          </g>
        ))}
        <rect x={at - 20} y="13" width="40" height="26" rx="4" class="carriage" />
        <path d={`M${at - 13} 22h26M${at - 13} 30h26`} class="carriage-lines" />
        {gripper && (
          <path
            d={[-1, 1].map((side) => `M${at} 13h${side * jaws[gripper]}v-11`).join("")}
            class={`jaws ${gripper}`}
          />
        )}
        <line x1={at} x2={at} y1="39" y2="50" class="needle" />
        {isApart(axis, reach) && (
          <rect x={commanded - 20} y="13" width="40" height="26" rx="4" class="ghost" />
        )}
        {axis.velocity !== 0 && (
          <path
            d={`M${at} 6h${arrow}m0 0l${-Math.sign(arrow) * 5} -3.5m${Math.sign(arrow) * 5} 3.5l${-Math.sign(arrow) * 5} 3.5`}
            class="arrow"
          />
        )}
      </svg>
    </div>
  );
}

/** The same in one row: the last state, and a rail as wide as there is place. */
export function AxisRow({ axis, reach, words }: AxisProps) {
  const onRail = (position: number) => 6 + placeOn(reach, position) * 188;
  const [state = "", kind = ""] = statesOf(axis, words).at(-1) ?? [];
  return (
    <div class={`axis-row ${colourOf(axis.axis)}`}>
      <strong>{words.axis(axis.axis)}</strong>
      <span class={`axis-state ${kind}`}>{state}</span>
      <svg
        viewBox="0 0 200 16"
        preserveAspectRatio="none"
        role="img"
        aria-label={labelOf(axis, words)}
      >
        <rect x="0" y="6.500" width="200" height="3" class="rail-bed" />
        <rect x={onRail(axis.actual) - 5} y="2" width="10" height="12" class="carriage" />
        {isApart(axis, reach) && (
          <rect x={onRail(axis.position) - 5} y="2" width="10" height="12" class="ghost" />
        )}
      </svg>
      <Readings axis={axis} />
    </div>
  );
}
