// An XY table of two axes: where the tool is, and the way that it has taken, which
// fades with its age.

import type { MachineWords } from "../texts/machine.js";
import {
  type AxisView,
  grown,
  type Place,
  placeOn,
  positionText,
  type Reach,
  trailOf,
} from "./axes.js";

const size = 260;
const edge = 10;

function onTable(part: number): number {
  return edge + part * (size - 2 * edge);
}

interface TableProps {
  x: AxisView;
  y: AxisView;
  reachX: Reach;
  reachY: Reach;
  /** Up to now. */
  way: readonly Place[];
  words: MachineWords;
}

export function Table({ x, y, way, words, ...props }: TableProps) {
  // A fast run goes further between two pictures than any of them shows.
  const reachX = way.reduce((reach, [at]) => grown(reach, at, x.positionUnit), props.reachX);
  const reachY = way.reduce((reach, [, at]) => grown(reach, at, y.positionUnit), props.reachY);
  const left = (value: number) => onTable(placeOn(reachX, value));
  const top = (value: number) => size - onTable(placeOn(reachY, value));
  const atX = left(x.position);
  const atY = top(y.position);
  const points = [...way, [x.position, y.position] as const].map(
    ([px, py]) => `${left(px).toFixed(1)},${top(py).toFixed(1)}`,
  );
  return (
    <svg
      viewBox={`0 0 ${size} ${size}`}
      role="img"
      aria-label={words.tableLabel(positionText(x), positionText(y))}
      class="table"
    >
      <rect x={edge} y={edge} width={size - 2 * edge} height={size - 2 * edge} class="table-bed" />
      {[0.25, 0.5, 0.75].map((part) => (
        <g key={part}>
          <line
            x1={onTable(part)}
            x2={onTable(part)}
            y1={edge}
            y2={size - edge}
            class="rail-tick"
          />
          <line
            y1={onTable(part)}
            y2={onTable(part)}
            x1={edge}
            x2={size - edge}
            class="rail-tick"
          />
        </g>
      ))}
      <line x1={atX} x2={atX} y1={edge} y2={size - edge} class="gantry" />
      {trailOf(points).map(({ part, opacity }, index) => (
        <polyline key={index} points={part.join(" ")} class="way" stroke-opacity={opacity} />
      ))}
      <circle cx={atX} cy={atY} r="6" class={`tool-point ${x.moving || y.moving ? "now" : ""}`} />
    </svg>
  );
}
