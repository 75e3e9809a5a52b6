// The screen of the scope, drawn by uPlot: each channel as an envelope of its least and largest
// values, so that no spike is lost.

import uPlot from "uplot";

import {
  divisions,
  inDivisions,
  type Setting,
  unitsPerDivision,
  valuesAtDivisions,
} from "./channels.js";
import { partWidth, type Sweep } from "./trigger.js";

/** Colours by the place of a channel; those of the page's style. */
export function channelColour(index: number): string {
  return getComputedStyle(document.documentElement)
    .getPropertyValue(`--channel-${index % 8}`)
    .trim();
}

function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** The envelope: at the time of each part its least and its largest value. */
export function envelope(sweep: Sweep, settings: Setting[]): uPlot.AlignedData {
  const parts = sweep.channels[0]?.least.length ?? 0;
  const width = partWidth(sweep, parts);
  const times: number[] = [];
  for (let index = 0; index < parts; ++index) {
    const begin = sweep.fromMs + index * width;
    times.push(begin, begin + width / 2);
  }
  const lines = settings.map((setting) => {
    const channel = sweep.channels.find(({ name }) => name === setting.name);
    if (!channel) return times.map(() => null);
    const per = unitsPerDivision(setting, channel);
    return channel.least.flatMap((low, index) => {
      const high = channel.largest[index] ?? low;
      const rises = (channel.least[index - 1] ?? low) <= low;
      const pair = rises ? [low, high] : [high, low];
      return pair.map((value) => inDivisions(value, per, setting.offset));
    });
  });
  return [times, ...lines];
}

/** Between the edges of the screen and its divisions, in pixels; the times are below. */
export const screenPadding = { top: 6, right: 24, bottom: 24 };

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
  /** What stands at the divisions, from below. */
  #values: string[] = [];

  constructor(private readonly host: HTMLElement) {}

  draw(sweep: Sweep, settings: Setting[], marks: Marks, look: string): void {
    const moved = this.#marks.scaleOf !== marks.scaleOf;
    this.#marks = marks;
    const before = this.#values;
    this.#values = valuesAtDivisions(sweep, settings[marks.scaleOf]);
    const { clientWidth, clientHeight } = this.host;
    const shape = `${settings.map(({ name }) => name).join(" ")} ${look}`;
    const data = envelope(sweep, settings);
    if (!this.#plot || this.#shape !== shape) {
      this.#plot?.destroy();
      this.#shape = shape;
      this.#plot = new uPlot(this.#options(settings, clientWidth, clientHeight), data, this.host);
    } else {
      this.#plot.setSize({ width: clientWidth, height: clientHeight });
      this.#plot.setData(data, false);
    }
    this.#plot.setScale("x", { min: sweep.fromMs, max: sweep.toMs });
    if (moved || before.join() !== this.#values.join()) this.#plot.redraw(false, true);
  }

  #options(settings: Setting[], width: number, height: number): uPlot.Options {
    const axis = {
      stroke: colour("--muted"),
      grid: { stroke: colour("--line"), width: 1 },
      ticks: { show: false },
      font: `11px ${colour("--sans")}`,
    };
    return {
      width,
      height,
      legend: { show: false },
      cursor: { show: false },
      // At the sides there is room for the halves of the first and the last time.
      padding: [screenPadding.top, screenPadding.right, 0, 0],
      scales: { x: { time: false }, y: { auto: false, range: [-divisions, divisions] } },
      axes: [
        { ...axis, size: screenPadding.bottom },
        {
          ...axis,
          size: 56,
          stroke: () => {
            const { scaleOf } = this.#marks;
            return scaleOf < 0 ? colour("--muted") : channelColour(scaleOf);
          },
          values: () => this.#values,
          splits: () => Array.from({ length: 2 * divisions + 1 }, (_, index) => index - divisions),
        },
      ],
      series: [
        {},
        ...settings.map((_, index) => ({
          stroke: channelColour(index),
          width: 1.5,
          points: { show: false },
        })),
      ],
      hooks: {
        draw: [
          (plot) => {
            this.#drawMarks(plot);
          },
        ],
      },
    };
  }

  #drawMarks(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const ratio = devicePixelRatio;
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
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      ctx.font = `${11 * ratio}px system-ui, sans-serif`;
      ctx.textAlign = "left";
      ctx.fillText(name, x + 3 * ratio, bbox.top + 11 * ratio);
      ctx.restore();
    };
    const { cursors, trigger } = this.#marks;
    if (trigger !== undefined) line(trigger, colour("--warn"), [2, 3], "T");
    cursors.forEach((time, index) => {
      line(time, colour("--ink"), [5, 3], index === 0 ? "A" : "B");
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
    context.fillStyle = colour("--surface");
    context.fillRect(0, 0, copy.width, copy.height);
    context.font = `${12 * devicePixelRatio}px system-ui, sans-serif`;
    context.textBaseline = "middle";
    [heading, ...legend].forEach((text, index) => {
      context.fillStyle = index === 0 ? colour("--ink") : channelColour(index - 1);
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
