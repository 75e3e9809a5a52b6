// The screen of the scope, drawn by uPlot: each channel as an envelope of its least and largest
// values, so that no spike is lost; digital channels in lanes below.

import uPlot from "uplot";

import { channelColour, token } from "../style/colours.js";
import { divisions, type Drawn, envelope, valuesAtDivisions } from "./channels.js";
import { drawLane, laneHeight, runsOf } from "./lanes.js";
import { partWidth, type Sweep } from "./trigger.js";

/** Between the edges of the screen and its divisions, in pixels; the values are at the left. */
export const screenPadding = { top: 6, right: 24, left: 56 };
/** How high the scale of the times is, below the lanes. */
const timesHeight = 24;
/** Between the scales and the screen, as uPlot has it. */
const scaleGap = 5;

export function lanesOf(drawn: Drawn[]): Drawn[] {
  return drawn.filter(({ isDigital }) => isDigital);
}

/** How high the divisions are together, in a screen of this height. */
export function divisionsHeight(height: number, lanes: number): number {
  return height - screenPadding.top - lanes * laneHeight - timesHeight;
}

/** Cursors and the trigger, drawn over the lines; times in ms. */
export interface Marks {
  cursors: number[];
  trigger?: number | undefined;
  /** The place of the channel whose values stand at the divisions. */
  scaleOf: number;
}

export class Plot {
  #plot: uPlot | undefined;
  #shape = "";
  #marks: Marks = { cursors: [], scaleOf: -1 };
  #sweep: Sweep | undefined;
  #drawn: Drawn[] = [];
  /** What stands at the divisions, from below. */
  #values: string[] = [];

  constructor(private readonly host: HTMLElement) {}

  draw(sweep: Sweep, drawn: Drawn[], marks: Marks, look: string): void {
    const moved = this.#marks.scaleOf !== marks.scaleOf;
    this.#marks = marks;
    this.#sweep = sweep;
    this.#drawn = drawn;
    const before = this.#values;
    this.#values = valuesAtDivisions(sweep, drawn[marks.scaleOf]);
    const { clientWidth, clientHeight } = this.host;
    const shape = JSON.stringify([drawn.map(({ name, isDigital }) => [name, isDigital]), look]);
    const data = envelope(sweep, drawn);
    if (!this.#plot || this.#shape !== shape) {
      this.#plot?.destroy();
      this.#shape = shape;
      this.#plot = new uPlot(this.#options(drawn, clientWidth, clientHeight), data, this.host);
    } else {
      this.#plot.setSize({ width: clientWidth, height: clientHeight });
      this.#plot.setData(data, false);
    }
    this.#plot.setScale("x", { min: sweep.fromMs, max: sweep.toMs });
    if (moved || before.join() !== this.#values.join()) this.#plot.redraw(false, true);
  }

  #options(drawn: Drawn[], width: number, height: number): uPlot.Options {
    const axis = {
      stroke: token("--muted"),
      grid: { stroke: token("--line"), width: 1 },
      ticks: { show: false },
      font: `11px ${token("--sans")}`,
    };
    const below = lanesOf(drawn).length * laneHeight;
    return {
      width,
      height,
      legend: { show: false },
      cursor: { show: false },
      // At the sides there is room for the halves of the first and the last time.
      padding: [screenPadding.top, screenPadding.right, 0, 0],
      scales: { x: { time: false }, y: { auto: false, range: [-divisions, divisions] } },
      axes: [
        { ...axis, size: below + timesHeight, gap: below + scaleGap },
        {
          ...axis,
          size: screenPadding.left,
          stroke: () => {
            const { scaleOf } = this.#marks;
            return scaleOf < 0 ? token("--muted") : channelColour(scaleOf);
          },
          values: () => this.#values,
          splits: () => Array.from({ length: 2 * divisions + 1 }, (_, index) => index - divisions),
        },
      ],
      series: [
        {},
        ...drawn.map((_, index) => ({
          stroke: channelColour(index),
          width: 1.5,
          points: { show: false },
        })),
      ],
      hooks: {
        draw: [
          (plot) => {
            this.#drawLanes(plot);
            this.#drawMarks(plot);
          },
        ],
      },
    };
  }

  /** The lanes, each with the number of its channel at the left. */
  #drawLanes(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const sweep = this.#sweep;
    const ratio = devicePixelRatio;
    lanesOf(this.#drawn).forEach((lane, order) => {
      const channel = sweep?.channels.find(({ name }) => name === lane.name);
      if (!sweep || !channel) return;
      const index = this.#drawn.indexOf(lane);
      const top = bbox.top + bbox.height + order * laneHeight * ratio;
      const width = partWidth(sweep, channel.least.length);
      const xOf = (part: number) => plot.valToPos(sweep.fromMs + part * width, "x", true);
      drawLane(ctx, runsOf(channel), top, xOf, ratio, channelColour(index));
      ctx.save();
      ctx.fillStyle = channelColour(index);
      ctx.font = `bold ${11 * ratio}px ${token("--sans")}`;
      ctx.textAlign = "right";
      ctx.textBaseline = "middle";
      ctx.fillText(String(index + 1), bbox.left - scaleGap * ratio, top + (laneHeight * ratio) / 2);
      ctx.restore();
    });
  }

  #drawMarks(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio;
    const bottom = bbox.top + bbox.height + lanesOf(this.#drawn).length * laneHeight * ratio;
    const line = (time: number, stroke: string, dash: number[], name: string) => {
      const x = plot.valToPos(time, "x", true);
      if (x < bbox.left || x > bbox.left + bbox.width) return;
      ctx.save();
      ctx.strokeStyle = stroke;
      ctx.fillStyle = stroke;
      ctx.lineWidth = ratio;
      ctx.setLineDash(dash.map((length) => length * ratio));
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bottom);
      ctx.stroke();
      ctx.font = `${11 * ratio}px system-ui, sans-serif`;
      ctx.textAlign = "left";
      ctx.fillText(name, x + 3 * ratio, bbox.top + 11 * ratio);
      ctx.restore();
    };
    const { cursors, trigger } = this.#marks;
    if (trigger !== undefined) line(trigger, token("--warn"), [2, 3], "T");
    cursors.forEach((time, index) => {
      line(time, token("--ink"), [5, 3], index === 0 ? "A" : "B");
    });
  }

  /** The time at a place of the screen, in pixels of the page. */
  timeAt(clientX: number): number | undefined {
    if (!this.#plot) return undefined;
    const box = this.#plot.over.getBoundingClientRect();
    return this.#plot.posToVal(clientX - box.left, "x");
  }

  /** The screen as a picture, under a heading and one line for each channel in its colour. */
  picture(heading: string, legend: string[]): Promise<Blob | null> {
    const { canvas } = this.#plot?.ctx ?? {};
    if (!canvas) return Promise.resolve(null);
    const copy = document.createElement("canvas");
    const line = 18 * devicePixelRatio;
    const top = (legend.length + 1) * line + line / 2;
    copy.width = canvas.width;
    copy.height = canvas.height + top;
    const context = copy.getContext("2d");
    if (!context) return Promise.resolve(null);
    context.fillStyle = token("--surface");
    context.fillRect(0, 0, copy.width, copy.height);
    context.font = `${12 * devicePixelRatio}px system-ui, sans-serif`;
    context.textBaseline = "middle";
    [heading, ...legend].forEach((text, index) => {
      context.fillStyle = index === 0 ? token("--ink") : channelColour(index - 1);
      context.fillText(text, line / 2, (index + 0.75) * line);
    });
    context.drawImage(canvas, 0, top);
    return new Promise((resolve) => {
      copy.toBlob(resolve);
    });
  }

  destroy(): void {
    this.#plot?.destroy();
  }
}
