// The machine: a stage or a row for each axis that is used, an XY table, outputs and inputs.

import type { Card } from "@oncard/engine";
import { computed, effect, signal } from "@preact/signals";

import { present, session } from "../session/bench.js";
import { record } from "../session/record.js";
import { source } from "../store/source.js";
import { texts } from "../texts/texts.js";
import { type AxisView, axesNamed, axesOf, grown, isUsed, type Reach } from "./axes.js";
import { Pins } from "./pins.js";
import { AxisRow, Stage } from "./stage.js";
import { Table } from "./table.js";

const reaches = signal<Map<number, Reach>>(new Map());
const used = signal<ReadonlySet<number>>(new Set());

/** What has been used since the program was loaded. */
effect(() => {
  const { value: card } = present.card;
  if (!card) return;
  const isStart = present.state.peek()?.head === 0;
  const axes = axesOf(card);
  const before = isStart ? new Set<number>() : used.peek();
  const fresh = axes.filter((axis) => isUsed(axis) && !before.has(axis.axis));
  if (isStart || fresh.length > 0)
    used.value = new Set([...before, ...fresh.map(({ axis }) => axis)]);
  const old = isStart ? new Map<number, Reach>() : reaches.peek();
  const next = new Map(old);
  for (const { axis, position, positionUnit } of axes) {
    next.set(axis, grown(old.get(axis), position, positionUnit));
  }
  reaches.value = next;
});

/** The axes that are shown: those that are used or that the lesson speaks of; otherwise the first. */
const shown = computed(() => {
  const named = record.value ? [] : axesNamed(source.lesson.value.scope ?? []);
  const numbers = new Set([...used.value, ...named]);
  return numbers.size > 0 ? numbers : new Set([1]);
});

/** More axes than these have a row each. */
const mostStages = 4;

const tableIsShown = signal<boolean | undefined>(undefined);

export function MachinePanel() {
  const { machine: t } = texts.value;
  const { value: card } = present.card;
  if (!card) {
    const isStarting = session.notice.value.kind === "starting";
    return <p class="muted empty">{isStarting ? texts.value.status.starting : t.idle}</p>;
  }
  const axes = axesOf(card).filter(({ axis }) => shown.value.has(axis));
  const [x, y] = axes;
  // Two axes with switches of their own are rather two stages than a table.
  const isTable = axes.length === 2 && axes.every(({ switches }) => switches.length === 0);
  const table = (tableIsShown.value ?? isTable) && x && y;
  return (
    <div class="machine">
      {axes.map((axis) =>
        axes.length > mostStages || (table && (axis === x || axis === y)) ? (
          <AxisRow key={axis.axis} axis={axis} reach={reachOf(axis)} />
        ) : (
          <Stage key={axis.axis} axis={axis} reach={reachOf(axis)} />
        ),
      )}
      <div class="machine-rest">
        {x && y && (
          <div class="table-box">
            <label class="row small">
              <input
                type="checkbox"
                checked={table !== undefined && table !== false}
                onChange={({ currentTarget }) => (tableIsShown.value = currentTarget.checked)}
              />
              {t.table}: {t.tableAxes(x.axis, y.axis)}
            </label>
            {table && <Table x={x} y={y} reachX={reachOf(x)} reachY={reachOf(y)} />}
          </div>
        )}
        <Words card={card} />
      </div>
    </div>
  );
}

/** A stage also reaches as far as its axis really is, and its switches. */
function reachOf({ axis, position, actual, switches, positionUnit }: AxisView): Reach {
  const places = [position, actual, ...switches.map(({ place }) => place)];
  const reach = reaches.value.get(axis);
  return places.reduce<Reach>(
    (before, place) => grown(before, place, positionUnit),
    grown(reach, position, positionUnit),
  );
}

function Words({ card }: { card: Card }) {
  const { machine: t } = texts.value;
  const outputs = card.words.find(({ name }) => name === "gpo");
  const inputs = card.words.filter(({ kind }) => kind === "input");
  const general = inputs.filter(({ name }) => name === "gpi");
  return (
    <div class="words">
      {outputs && (
        <div>
          <h3>{t.outputs}</h3>
          <Pins word={outputs} pins={16} />
        </div>
      )}
      <div>
        <h3>{t.inputs}</h3>
        {general.map((word) => (
          <Pins key={word.name} word={word} pins={word.pins ?? 16} />
        ))}
        <details>
          <summary class="small">{t.moreInputs}</summary>
          {inputs
            .filter(({ name }) => name !== "gpi")
            .map((word) => (
              <div key={word.name} class="word">
                <span class="small muted">{word.name}</span>
                <Pins word={word} pins={word.pins ?? 8} />
              </div>
            ))}
        </details>
      </div>
    </div>
  );
}
