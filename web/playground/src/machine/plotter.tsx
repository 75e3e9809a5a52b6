// An XY table from above: its bed with scales, the gantry and the tool, the way that it has taken, which
// fades with its age, and the way that is planned. A third axis is a ruler beside it.

import type { MachineWords } from "../texts/machine.js";
import { number } from "../texts/number.js";
import {
  type AxisView,
  grownTo,
  type Place,
  placeOn,
  positionText,
  type Reach,
  sameScale,
  trailOf,
} from "./axes.js";
import { colourOf } from "./readings.js";

/** The bed, and what is around it. */
const bed = { left: 64, top: 14, size: 320 };
const right = bed.left + bed.size;
const bottom = bed.top + bed.size;
const height = bottom + 40;
/** The gantry's rails stand so far from the bed. */
const rail = 14;
/** Where Z stands. */
const ruler = right + 52;
const parts = Array.from({ length: 11 }, (_, index) => index / 10);

export interface PlotterProps {
  x: AxisView;
  y: AxisView;
  z?: AxisView | undefined;
  reachOf: (axis: AxisView) => Reach;
  /** Up to now. */
  way: readonly Place[];
  /** From now on, as far as it is planned. */
  ahead: readonly Place[];
  words: MachineWords;
}

export function Plotter({ x, y, z, way, ahead, words, reachOf }: PlotterProps) {
  // A fast run goes further between two pictures than any of them shows.
  const places = [...way, ...ahead];
  const [reachX, reachY] = sameScale(
    grownTo(
      reachOf(x),
      places.map(([at]) => at),
      x.positionUnit,
    ),
    grownTo(
      reachOf(y),
      places.map(([, at]) => at),
      y.positionUnit,
    ),
  );
  const left = (value: number) => bed.left + placeOn(reachX, value) * bed.size;
  const top = (value: number) => bottom - placeOn(reachY, value) * bed.size;
  const pointOf = ([px, py]: Place) => `${left(px).toFixed(1)},${top(py).toFixed(1)}`;
  const commanded: Place = [x.position, y.position];
  const at = { x: left(x.actual), y: top(y.actual) };
  const positions = [x, y, ...(z ? [z] : [])].map(positionText).join(", ");
  return (
    <svg
      viewBox={`0 0 ${z ? ruler + 64 : right + 32} ${height}`}
      role="img"
      aria-label={words.tableLabel(positions)}
      class="table"
    >
      <rect
        x={bed.left - rail - 8}
        y={bed.top - 12}
        width={bed.size + 2 * (rail + 8)}
        height={bed.size + 24}
        rx="10"
        class="table-frame"
      />
      <rect x={bed.left} y={bed.top} width={bed.size} height={bed.size} class="table-bed" />
      <Scales reachX={reachX} reachY={reachY} />
      <polyline points={ahead.map(pointOf).join(" ")} class="way-ahead" />
      {trailOf([...way, commanded].map(pointOf)).map(({ part, opacity }, index) => (
        <polyline key={index} points={part.join(" ")} class="way" stroke-opacity={opacity} />
      ))}
      <Gantry at={at} moves={x.moving || y.moving} />
      {Math.hypot(left(x.position) - at.x, top(y.position) - at.y) > 1 && (
        <circle cx={left(x.position)} cy={top(y.position)} r="8" class="ghost" />
      )}
      {z && <Ruler axis={z} reach={reachOf(z)} />}
    </svg>
  );
}

function Scales({ reachX, reachY }: { reachX: Reach; reachY: Reach }) {
  const valueAt = ({ least, largest }: Reach, part: number) =>
    number(least + part * (largest - least), 1);
  return (
    <>
      {parts.map((part, index) => {
        const x = bed.left + part * bed.size;
        const y = bottom - part * bed.size;
        const isLong = index % 2 === 0;
        return (
          <g key={part}>
            <path d={`M${x} ${bed.top}V${bottom}M${bed.left} ${y}H${right}`} class="table-line" />
            <path
              d={`M${x} ${bottom + 13}v${isLong ? 6 : 3}M${bed.left - rail - 9} ${y}h${isLong ? -6 : -3}`}
              class="rail-tick"
            />
            {isLong && (
              <>
                <text x={x} y={height - 8} class="rail-text" text-anchor="middle">
                  {valueAt(reachX, part)}
                </text>
                {index > 0 && (
                  <text x={bed.left - rail - 18} y={y + 4} class="rail-text" text-anchor="end">
                    {shortened(reachY.least + part * (reachY.largest - reachY.least))}
                  </text>
                )}
              </>
            )}
          </g>
        );
      })}
    </>
  );
}

/** Thousands as `12k`: beside the table there is little room. */
function shortened(value: number): string {
  return Math.abs(value) >= 1000 ? `${number(value / 1000, 1)}k` : number(value, 1);
}

function Gantry({ at, moves }: { at: { x: number; y: number }; moves: boolean }) {
  return (
    <>
      {[bed.left - rail - 4, right + rail - 4].map((x) => (
        <rect
          key={x}
          x={x}
          y={bed.top - 8}
          width="8"
          height={bed.size + 16}
          rx="3"
          class="table-rail"
        />
      ))}
      <g class="gantry">
        <rect
          x={bed.left - rail - 6}
          y={at.y - 30}
          width={bed.size + 2 * (rail + 6)}
          height="20"
          rx="5"
          class="table-rail"
        />
        <path d={`M${bed.left} ${at.y - 20}H${right}`} class="gantry-screw" />
      </g>
      {[bed.left - rail - 9, right + rail - 9].map((x) => (
        <rect key={x} x={x} y={at.y - 33} width="18" height="26" rx="4" class="motor" />
      ))}
      <rect x={at.x - 14} y={at.y - 36} width="28" height="30" rx="5" class="head" />
      <path d={`M${at.x - 5} ${at.y - 6}h10l-5 6z`} class="head" />
      {moves && <circle cx={at.x} cy={at.y} r="14" class="glow" />}
      <circle cx={at.x} cy={at.y} r="5" class={`tool-point ${moves ? "now" : ""}`} />
    </>
  );
}

/** Z beside the table: up is up. */
function Ruler({ axis, reach }: { axis: AxisView; reach: Reach }) {
  const top = (value: number) => bottom - placeOn(reach, value) * bed.size;
  return (
    <g class={colourOf(axis.axis)}>
      <rect x={ruler - 4} y={bed.top} width="8" height={bed.size} rx="3" class="table-rail" />
      {parts.map((part, index) => (
        <g key={part}>
          <path
            d={`M${ruler + 16} ${bottom - part * bed.size}h${index % 2 === 0 ? 6 : 3}`}
            class="rail-tick"
          />
          {index % 2 === 0 && (
            <text x={ruler + 26} y={bottom - part * bed.size + 4} class="rail-text">
              {shortened(reach.least + part * (reach.largest - reach.least))}
            </text>
          )}
        </g>
      ))}
      <rect
        x={ruler - 12}
        y={top(axis.actual) - 9}
        width="24"
        height="18"
        rx="4"
        class="carriage"
      />
      {Math.abs(top(axis.position) - top(axis.actual)) > 1 && (
        <rect
          x={ruler - 12}
          y={top(axis.position) - 9}
          width="24"
          height="18"
          rx="4"
          class="ghost"
        />
      )}
      <text x={ruler} y={height - 8} class="rail-text" text-anchor="middle">
        Z
      </text>
    </g>
  );
}
