// The handle of the trigger's level, on the scale of its source.

import { useEffect } from "preact/hooks";

import { present } from "../session/bench.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import {
  divisions,
  type Drawn,
  inDivisions,
  unitsOf,
  unitsPerDivision,
  valueAt,
} from "./channels.js";
import { Handle } from "./handle.js";
import { drawn, drawnSource, holdScale, scope, triggers, turnKnobs } from "./settings.js";
import type { Sweep } from "./trigger.js";

/** The source of the trigger, and where its level is, in divisions from the middle. */
interface Place {
  source: Drawn;
  index: number;
  perDivision: number;
  at: number;
}

/** Undefined where no trigger is used, and where its source has no scale, or none yet. */
export function placeOfLevel(sweep: Sweep): Place | undefined {
  if (!triggers.value) return undefined;
  const { value: source } = drawnSource;
  const channel = sweep.channels.find(({ name }) => name === source?.name);
  if (!source || source.isDigital || !channel) return undefined;
  const perDivision = unitsPerDivision(source, channel);
  const at = inDivisions(scope.level.value, perDivision, source.offset);
  return { source, index: drawn.value.indexOf(source), perDivision, at };
}

function letGo(): void {
  holdScale(undefined);
}

export function Level(props: { place: Place; height: number; beside: number }) {
  const { place, height, beside } = props;
  const { source, index, perDivision, at } = place;
  const { scope: t } = texts.value;
  const { value: level } = scope.level;
  const unit = unitsOf(present.card.value).get(source.name);
  const text = unit === undefined ? number(level) : `${number(level)} ${unit}`;
  const edge = (height: number) => valueAt(height, perDivision, source.offset);
  const isAbove = at > divisions;
  const isBelow = at < -divisions;
  // A handle that vanishes is not let go.
  useEffect(() => letGo, []);
  return (
    <Handle
      class={`of${index % 8}`}
      label={t.levelOf(source.name)}
      at={at}
      height={height}
      beside={beside}
      value={level}
      valueText={isAbove ? t.above(text) : isBelow ? t.below(text) : text}
      least={Math.min(level, edge(-divisions))}
      largest={Math.max(level, edge(divisions))}
      onPut={(wished) => {
        turnKnobs({ level: edge(wished) });
      }}
      onTake={() => {
        holdScale({ name: source.name, perDivision });
      }}
      onLeave={letGo}
    >
      {isAbove ? "T↑" : isBelow ? "T↓" : "T"}
    </Handle>
  );
}
