// What every part of a frame is painted with.

import type { Box } from "./layout.js";
import type { Look } from "./look.js";

export class Pen {
  constructor(
    readonly context: CanvasRenderingContext2D,
    readonly look: Look,
  ) {}

  fill({ left, top, width, height }: Box, colour: string, radius = 0): void {
    const { context } = this;
    context.fillStyle = colour;
    context.beginPath();
    // Safari before 16 has no rectangles with round corners.
    if (radius > 0 && "roundRect" in context) context.roundRect(left, top, width, height, radius);
    else context.rect(left, top, width, height);
    context.fill();
  }

  line(
    from: readonly [number, number],
    to: readonly [number, number],
    colour: string,
    width = 1,
  ): void {
    this.polyline([from, to], colour, width);
  }

  polyline(points: readonly (readonly [number, number])[], colour: string, width: number): void {
    const { context } = this;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.lineJoin = "round";
    context.beginPath();
    for (const [x, y] of points) context.lineTo(x, y);
    context.stroke();
  }

  dot([x, y]: readonly [number, number], radius: number, colour: string): void {
    const { context } = this;
    context.fillStyle = colour;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fill();
  }

  /**
   * Writes a text whose middle is at a height; `x` is its left end, or the one that `align` says.
   * @param most with so much place; a longer one ends with an ellipsis
   * @returns how wide it is
   */
  write(
    text: string,
    [x, y]: readonly [number, number],
    { size, weight = 400, colour = this.look.ink, align = "left", most = Infinity }: Writing,
  ): number {
    const { context, look } = this;
    context.font = `${weight} ${size}px ${look.sans}`;
    context.fillStyle = colour;
    context.textAlign = align;
    context.textBaseline = "middle";
    const shown = this.#fitted(text, most);
    context.fillText(shown, x, y);
    return context.measureText(shown).width;
  }

  #fitted(text: string, most: number): string {
    const isWide = (each: string) => this.context.measureText(each).width > most;
    if (!isWide(text)) return text;
    const characters = Array.from(text);
    while (characters.length > 1 && isWide(`${characters.join("")}…`)) characters.pop();
    return `${characters.join("")}…`;
  }
}

interface Writing {
  size: number;
  weight?: 400 | 600 | 700;
  colour?: string;
  align?: "left" | "right" | "center";
  most?: number;
}
