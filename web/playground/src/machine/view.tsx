// The machine: a table, or a stage or a row for each axis that is used, and outputs and inputs. How it
// looks the scenario says (`[view]`). The page and the extension for Visual Studio Code show it.

import type { Card } from "@oncard/engine";
import { signal } from "@preact/signals";

import type { MachineWords } from "../texts/machine.js";
import {
  aheadOf,
  type AxisView,
  grownTo,
  isTable,
  mostStages,
  pin,
  type Place,
  type Reach,
  type TableAxes,
  tableAxes,
} from "./axes.js";
import { Conveyor } from "./conveyor.js";
import { NamedPin, Pins, type SetInput } from "./pins.js";
import { Plotter } from "./plotter.js";
import { colourOf, Readings, States } from "./readings.js";
import { Rotary } from "./rotary.js";
import type { Seen } from "./seen.js";
import { AxisRow, Stage } from "./stage.js";

/** Whether the reader wants a table; until then the machine decides. */
const tableIsWanted = signal<boolean | undefined>(undefined);

/** The axes of the table, if one is shown. */
export function tableOf(card: Card, axes: readonly AxisView[]): TableAxes | undefined {
  return (tableIsWanted.value ?? isTable(card, axes)) ? tableAxes(card, axes) : undefined;
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
  const table = tableOf(card, axes);
  const others = axes.filter((axis) => !table || !Object.values(table).includes(axis));
  const reachOf = (axis: AxisView) => withSwitches(axis, seen.reaches[axis.axis]);
  const pins = <Words card={card} words={words} onInput={onInput} />;
  return (
    <div class="machine">
      <Head card={card} axes={axes} isTable={table !== undefined} words={words} />
      {table && (
        <div class="plotter">
          <Plotter
            {...table}
            reachOf={reachOf}
            way={way}
            ahead={aheadOf(card.paths, table)}
            words={words}
          />
          <div class="plotter-side">
            {(["x", "y", "z"] as const).map((name) => {
              const axis = table[name];
              return axis && <Coordinate key={name} name={name} axis={axis} words={words} />;
            })}
            {pins}
          </div>
        </div>
      )}
      {others.map((axis) => {
        const isRow = axes.length > mostStages || table !== undefined;
        const props = { axis, reach: reachOf(axis), words };
        return isRow ? (
          <AxisRow key={axis.axis} {...props} />
        ) : (
          <Picture key={axis.axis} card={card} {...props} />
        );
      })}
      {!table && pins}
    </div>
  );
}

/** What the machine is called, and whether it is a table. */
function Head(props: {
  card: Card;
  axes: readonly AxisView[];
  isTable: boolean;
  words: MachineWords;
}) {
  const { card, axes, words } = props;
  const { title } = card.view;
  const canBeTable = tableAxes(card, axes) !== undefined;
  if (title === "" && !canBeTable) return null;
  const choice = (wanted: boolean, text: string) => (
    <button
      type="button"
      class="quiet"
      aria-pressed={props.isTable === wanted}
      onClick={() => (tableIsWanted.value = wanted)}
    >
      {text}
    </button>
  );
  return (
    <div class="row machine-head">
      <strong class="grow">{title}</strong>
      {canBeTable && (
        <div role="group" aria-label={words.look}>
          {choice(true, words.table)}
          {choice(false, words.axes)}
        </div>
      )}
    </div>
  );
}

/** An axis of a table. */
function Coordinate(props: { name: "x" | "y" | "z"; axis: AxisView; words: MachineWords }) {
  const { name, axis, words } = props;
  return (
    <div class={`coordinate ${colourOf(axis.axis)}`}>
      <div class="row small muted">
        {name.toUpperCase()} · {words.axis(axis.axis)}
      </div>
      <Readings axis={axis} />
      <div class="row">
        <States axis={axis} words={words} />
      </div>
    </div>
  );
}

interface PictureProps {
  card: Card;
  axis: AxisView;
  reach: Reach;
  words: MachineWords;
}

/** An axis as the kind of the machine wants it. */
function Picture({ card, axis, reach, words }: PictureProps) {
  const { kind, x, turn } = card.view;
  if (axis.axis === x && kind === "rotary") return <Rotary axis={axis} turn={turn} words={words} />;
  if (axis.axis === x && kind === "conveyor") return <Conveyor axis={axis} words={words} />;
  const hasGripper = axis.axis === x && kind === "gripper";
  return (
    <Stage
      axis={axis}
      reach={reach}
      words={words}
      gripper={hasGripper ? (gripperIsClosed(card) ? "closed" : "open") : undefined}
    />
  );
}

/** The first output that the machine names closes its gripper. */
function gripperIsClosed(card: Card): boolean {
  const output = card.view.pins.find(({ type }) => type === "gpo");
  return pin(card, "gpo", output?.index ?? 1);
}

/** A stage also reaches as far as its axis really is, and its switches. */
function withSwitches(axis: AxisView, reach: Reach | undefined): Reach {
  const { position, actual, switches, positionUnit } = axis;
  const places = [position, actual, ...switches.map(({ place }) => place)];
  return grownTo(reach, places, positionUnit);
}

type WordsProps = Pick<MachineViewProps, "card" | "words" | "onInput">;

/** Where the machine names pins, only these are shown at first. */
function Words(props: WordsProps) {
  const { pins } = props.card.view;
  if (pins.length === 0) return <AllWords {...props} />;
  return (
    <div class="words">
      {pins.map((named) => (
        <NamedPin key={`${named.type} ${named.index}`} pin={named} {...props} />
      ))}
      <details>
        <summary class="small">{props.words.allPins}</summary>
        <AllWords {...props} />
      </details>
    </div>
  );
}

function AllWords({ card, words, onInput }: WordsProps) {
  const outputs = card.words.find(({ name }) => name === "gpo");
  const inputs = card.words.filter(({ kind }) => kind === "input");
  const general = inputs.filter(({ name }) => name === "gpi");
  const pins = { words, onInput };
  return (
    <div class="words">
      {outputs && (
        <div>
          <h3>{words.outputs}</h3>
          <Pins word={outputs} {...pins} />
        </div>
      )}
      <div>
        <h3>{words.inputs}</h3>
        {general.map((word) => (
          <Pins key={word.name} word={word} {...pins} />
        ))}
        <details>
          <summary class="small">{words.moreInputs}</summary>
          {inputs
            .filter(({ name }) => name !== "gpi")
            .map((word) => (
              <div key={word.name} class="word">
                <span class="small muted">{word.name}</span>
                <Pins word={word} {...pins} />
              </div>
            ))}
        </details>
      </div>
    </div>
  );
}
