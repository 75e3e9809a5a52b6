// The machine: a stage or a row for each axis that is used, an XY table, outputs and inputs. The
// page and the extension for Visual Studio Code show it.

import type { Card } from "@oncard/engine";
import { signal } from "@preact/signals";

import type { MachineWords } from "../texts/machine.js";
import { type AxisView, grown, type Place, type Reach } from "./axes.js";
import { Pins, type SetInput } from "./pins.js";
import type { Seen } from "./seen.js";
import { AxisRow, Stage } from "./stage.js";
import { Table } from "./table.js";

/** More axes than these have a row each. */
const mostStages = 4;

/** Whether the reader wants a table; until then the axes decide. */
const tableIsWanted = signal<boolean | undefined>(undefined);

/** The axes of the table, if there is one. */
export function tableOf(axes: readonly AxisView[]): { x: AxisView; y: AxisView } | undefined {
  const [x, y] = axes;
  // Two axes with switches of their own are rather two stages than a table.
  const isTable = axes.length === 2 && axes.every(({ switches }) => switches.length === 0);
  return x && y && (tableIsWanted.value ?? isTable) ? { x, y } : undefined;
}

export interface MachineViewProps {
  card: Card;
  axes: readonly AxisView[];
  seen: Seen;
  /** The way of the table up to now. */
  way: readonly Place[];
  words: MachineWords;
  onInput: SetInput;
}

export function MachineView({ card, axes, seen, way, words, onInput }: MachineViewProps) {
  const [x, y] = axes;
  const table = tableOf(axes);
  const reachOf = (axis: AxisView) => withSwitches(axis, seen.reaches[axis.axis]);
  return (
    <div class="machine">
      {axes.map((axis) => {
        const isRow = axes.length > mostStages || (table && (axis === x || axis === y));
        const Shown = isRow ? AxisRow : Stage;
        return <Shown key={axis.axis} axis={axis} reach={reachOf(axis)} words={words} />;
      })}
      <div class="machine-rest">
        {x && y && (
          <div class="table-box">
            <label class="row small">
              <input
                type="checkbox"
                checked={table !== undefined}
                onChange={({ currentTarget }) => (tableIsWanted.value = currentTarget.checked)}
              />
              {words.table}: {words.tableAxes(x.axis, y.axis)}
            </label>
            {table && (
              <Table x={x} y={y} reachX={reachOf(x)} reachY={reachOf(y)} way={way} words={words} />
            )}
          </div>
        )}
        <Words card={card} words={words} onInput={onInput} />
      </div>
    </div>
  );
}

/** A stage also reaches as far as its axis really is, and its switches. */
function withSwitches(axis: AxisView, reach: Reach | undefined): Reach {
  const { position, actual, switches, positionUnit } = axis;
  const places = [position, actual, ...switches.map(({ place }) => place)];
  return places.reduce<Reach>(
    (before, place) => grown(before, place, positionUnit),
    grown(reach, position, positionUnit),
  );
}

function Words({ card, words, onInput }: Pick<MachineViewProps, "card" | "words" | "onInput">) {
  const outputs = card.words.find(({ name }) => name === "gpo");
  const inputs = card.words.filter(({ kind }) => kind === "input");
  const general = inputs.filter(({ name }) => name === "gpi");
  const pins = { words, onInput };
  return (
    <div class="words">
      {outputs && (
        <div>
          <h3>{words.outputs}</h3>
          <Pins word={outputs} pins={16} {...pins} />
        </div>
      )}
      <div>
        <h3>{words.inputs}</h3>
        {general.map((word) => (
          <Pins key={word.name} word={word} pins={word.pins ?? 16} {...pins} />
        ))}
        <details>
          <summary class="small">{words.moreInputs}</summary>
          {inputs
            .filter(({ name }) => name !== "gpi")
            .map((word) => (
              <div key={word.name} class="word">
                <span class="small muted">{word.name}</span>
                <Pins word={word} pins={word.pins ?? 8} {...pins} />
              </div>
            ))}
        </details>
      </div>
    </div>
  );
}
