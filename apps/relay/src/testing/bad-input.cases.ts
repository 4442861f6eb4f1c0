/**
 * Every kind of bad input at some doors. A cell says what is answered and, behind the bar, words of the answer
 * that tell its sender what to mend. A bystander on the same relay drives on by the lines that it had.
 */
import { describe, expect, it } from "vitest";
import { Bystander } from "./bystander.ts";
import { badInputs, type BadInput, type Knock } from "./doors.ts";
import { startTestRelay } from "./test-relay.ts";

export interface Door {
  knocks: Partial<Record<BadInput, Knock>>;
  /** null: the door takes nothing of this kind */
  answers: Record<BadInput, string | null>;
}

export function testDoors(doors: Record<string, Door>): void {
  const cells = Object.entries(doors).flatMap(([door, { knocks, answers }]) =>
    badInputs.flatMap((bad) => {
      const [answer, words = ""] = (answers[bad] ?? "").split(" | ");
      return answer === "" ? [] : [{ door, bad, knock: knocks[bad], answer, words }];
    }),
  );

  describe("bad input", () => {
    it.each(cells)("at $door: $bad", async ({ knock, answer, words }) => {
      const relay = await startTestRelay();
      const bystander = await Bystander.at(relay);
      const place = { relay, robot: await relay.register(), other: bystander.robot };
      const told = await knock?.(place);
      expect(told).toMatchObject({ answer, says: expect.stringContaining(words) });
      await bystander.drives();
    });
  });
}
