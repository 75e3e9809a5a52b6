// Where a scenario asks for what does not hold.
// Tested by test/required.test.ts.

/**
 * The line of a scenario, from 1, with the condition that a message begins with. Undefined if there is
 * none: what does not hold may be nothing that the scenario says.
 */
export function lineOfCondition(message: string, scenario: string): number | undefined {
  let found: number | undefined;
  let longest = 0;
  for (const [index, line] of scenario.split("\n").entries()) {
    if (line.trimStart().startsWith("#")) continue;
    for (const [, condition = ""] of line.matchAll(/"([^"]+)"/g)) {
      // One condition may begin as another one does.
      const isWhole =
        message.startsWith(condition) && !/^[\w.]/.test(message.slice(condition.length));
      if (!isWhole || condition.length <= longest) continue;
      found = index + 1;
      longest = condition.length;
    }
  }
  return found;
}
