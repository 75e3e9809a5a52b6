// An XY table of two axes: where the tool is, and the way that it has taken, which
// fades with its age.

import { useAsked } from "../session/asked.js";
import { bench, present, session } from "../session/bench.js";
import { texts } from "../texts/texts.js";
import { type AxisView, grown, placeOn, positionText, type Reach, trailOf, wayOf } from "./axes.js";

const size = 260;
const edge = 10;
const pathPoints = 300;

function onTable(part: number): number {
  return edge + part * (size - 2 * edge);
}

export function Table(props: { x: AxisView; y: AxisView; reachX: Reach; reachY: Reach }) {
  const { x, y } = props;
  const { machine: t } = texts.value;
  const path = usePath(x.axis, y.axis);
  // A fast run goes further between two pictures than any of them shows.
  const reachX = path.reduce((reach, [at]) => grown(reach, at, x.positionUnit), props.reachX);
  const reachY = path.reduce((reach, [, at]) => grown(reach, at, y.positionUnit), props.reachY);
  const left = (value: number) => onTable(placeOn(reachX, value));
  const top = (value: number) => size - onTable(placeOn(reachY, value));
  const atX = left(x.position);
  const atY = top(y.position);
  const points = [...path, [x.position, y.position] as const].map(
    ([px, py]) => `${left(px).toFixed(1)},${top(py).toFixed(1)}`,
  );
  return (
    <svg
      viewBox={`0 0 ${size} ${size}`}
      role="img"
      aria-label={t.tableLabel(positionText(x), positionText(y))}
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

/** The positions up to now. */
function usePath(x: number, y: number): (readonly [number, number])[] {
  const time = present.state.value?.time_ms ?? 0;
  const key = `${x} ${y} ${time} ${session.history.value}`;
  const ask = async () => {
    if (time === 0) return [];
    const engine = await bench.engine();
    const names = [`axis${x}.prfPos`, `axis${y}.prfPos`];
    const [xs, ys] = await engine.trace(names, 0, time, pathPoints);
    if (!xs || !ys) return [];
    const tops = wayOf(ys);
    return wayOf(xs).map((value, index) => [value, tops[index] ?? 0] as const);
  };
  return useAsked(key, ask, session.running.value) ?? [];
}
