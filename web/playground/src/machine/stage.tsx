// A linear stage: a carriage between two limit switches, with an arrow as long as it is fast.

import { number, texts } from "../texts/texts.js";
import {
  type AxisView,
  placeOn,
  positionNumber,
  positionText,
  type Reach,
  roundUp,
} from "./axes.js";

const width = 400;
const left = 18;
const right = width - 18;

export function Stage({ axis, reach }: { axis: AxisView; reach: Reach }) {
  const { machine: t } = texts.value;
  const at = left + 14 + placeOn(reach, axis.position) * (right - left - 28);
  const speed = Math.min(
    1,
    Math.abs(axis.velocity) / roundUp(Math.max(100, Math.abs(axis.velocity))),
  );
  const arrow = Math.sign(axis.velocity) * (8 + speed * 52);
  const flags = [
    [axis.servoOn ? t.servo : t.off, axis.servoOn ? "good" : ""],
    ...(axis.moving ? [[t.moving, "now"]] : []),
    ...(axis.alarm ? [[t.alarm, "bad"]] : []),
    ...(axis.followingError ? [[t.followingError, "bad"]] : []),
  ];
  const position = positionNumber(axis);
  const velocity = number(axis.velocity, 2);
  return (
    <div class={`stage a${(axis.axis - 1) % 8}`}>
      <div class="row">
        <strong>{t.axis(axis.axis)}</strong>
        {flags.map(([text, kind]) => (
          <span key={text} class={`tag ${kind}`}>
            {text}
          </span>
        ))}
        <span class="grow" />
        <output class="reading" data-axis={axis.axis}>
          {position}
          <small> {axis.positionUnit}</small>
        </output>
        <output class="reading">
          {velocity}
          <small> {axis.velocityUnit}</small>
        </output>
      </div>
      <svg
        viewBox={`0 0 ${width} 40`}
        role="img"
        aria-label={t.stage(axis.axis, positionText(axis), `${velocity} ${axis.velocityUnit}`)}
        class="rail"
      >
        <rect x={left} y="24" width={right - left} height="4" class="rail-bed" />
        {[0, 0.25, 0.5, 0.75, 1].map((part) => {
          const x = left + 14 + part * (right - left - 28);
          return <line key={part} x1={x} x2={x} y1="28" y2="32" class="rail-tick" />;
        })}
        <Switch x={6} label={t.negative} on={axis.negativeLimit} />
        <Switch x={width - 6} label={t.positive} on={axis.positiveLimit} />
        <rect x={at - 13} y="12" width="26" height="12" rx="2" class="carriage" />
        <line x1={at} x2={at} y1="24" y2="32" class="needle" />
        {axis.velocity !== 0 && (
          <path
            d={`M${at} 6h${arrow}m0 0l${-Math.sign(arrow) * 5} -3.5m${Math.sign(arrow) * 5} 3.5l${-Math.sign(arrow) * 5} 3.5`}
            class="arrow"
          />
        )}
        <text x={left + 14} y="39" class="rail-text" text-anchor="middle">
          {number(reach.least, 0)}
        </text>
        <text x={right - 14} y="39" class="rail-text" text-anchor="middle">
          {number(reach.largest, 0)}
        </text>
      </svg>
    </div>
  );
}

function Switch({ x, label, on }: { x: number; label: string; on: boolean }) {
  return (
    <g class={`switch ${on ? "on" : ""}`}>
      <title>{label}</title>
      <rect x={x - 4} y="16" width="8" height="14" rx="1.5" />
    </g>
  );
}
