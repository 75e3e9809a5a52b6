// A place for programs that belong to no lesson: two axes that move one after the other.

import type { Lesson } from "@oncard/lessons";

const program = `/* Axis 1 travels first, then axis 2. */
TTrapPrm trap;

int main()
{
  int moving;
  int status;
  int clock;

  trap.acc = 0.25;
  trap.dec = 0.125;
  trap.smoothTime = 25;
  GT_AxisOn(1);
  GT_PrfTrap(1);
  GT_SetTrapPrm(1, &trap);
  GT_SetPos(1, 50000);
  GT_SetVel(1, 50);
  GT_Update(1);
lbl_wait:
  GT_GetSts(1, &status, 1, &clock);
  moving = status & 0x400;
  if (moving) goto lbl_wait;
  GT_AxisOn(2);
  GT_PrfTrap(2);
  GT_SetTrapPrm(2, &trap);
  GT_SetPos(2, 30000);
  GT_SetVel(2, 50);
  GT_Update(2);
  return 0;
}
`;

const scenario = `program = "program.c"
until_ms = 2500

# What must hold at the end, for example:
# expect = ["axis1.prfPos == 50000", "axis2.prfPos == 30000"]
`;

export const ownProgram: Lesson = {
  version: 1,
  id: "own",
  title: { en: "Your own program", zh: "自己的程序" },
  text: {
    en: "Write a program for the card, run it, and look into it. The scenario beside it says how its threads start, what happens around the card, and what must hold.",
    zh: "为控制卡编写程序，运行并观察它。旁边的场景文件说明线程如何启动、卡的周围发生什么，以及必须成立的条件。",
  },
  hints: [],
  files: { "program.c": program, "scenario.toml": scenario },
  program: "program.c",
  main: "scenario.toml",
  task: "run",
  scope: ["axis1.prfVel", "axis2.prfVel"],
};

/** Whether nothing is to be read beside a program: it belongs neither to a lesson nor to a sample. */
export function isFree({ text }: Lesson): boolean {
  return text === ownProgram.text;
}

/**
 * The place for programs of the reader's own, with the names of the files that are there. Those of a
 * sample also bring its words and its channels.
 */
export function ownProgramOf(files: Record<string, string>, samples: readonly Lesson[]): Lesson {
  const { program: usual, main: usualMain } = ownProgram;
  if (Object.hasOwn(files, usual) && Object.hasOwn(files, usualMain)) return ownProgram;
  const names = Object.keys(files);
  const known = samples.find(
    (each) => String(Object.keys(each.files).sort()) === String([...names].sort()),
  );
  if (known) return { ...known, id: ownProgram.id };
  const program = names.find((name) => name.endsWith(".c"));
  const main = names.find((name) => name.endsWith(".toml"));
  return program === undefined || main === undefined
    ? ownProgram
    : { ...ownProgram, program, main };
}
