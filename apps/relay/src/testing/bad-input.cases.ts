/**
 * Test cases for invalid input at the endpoints of a relay. A cell contains the expected status
 * and, after the bar, a part of the error that helps its sender. Another robot on the same relay
 * must not be affected.
 */
import { describe, expect, it } from "vitest";
import { Bystander } from "./bystander.ts";
import { badInputs, type BadInput, type Attempt } from "./endpoints.ts";
import { startTestRelay } from "./test-relay.ts";

export interface Endpoint {
  attempts: Partial<Record<BadInput, Attempt>>;
  /** expected outcomes; null: the endpoint accepts nothing of this kind */
  answers: Record<BadInput, string | null>;
}

export function testEndpoints(endpoints: Record<string, Endpoint>): void {
  const cells = Object.entries(endpoints).flatMap(([endpoint, { attempts, answers }]) =>
    badInputs.flatMap((bad) => {
      const [answer, words = ""] = (answers[bad] ?? "").split(" | ");
      return answer === "" ? [] : [{ endpoint, bad, attempt: attempts[bad], answer, words }];
    }),
  );

  describe("bad input", () => {
    it.each(cells)("at $endpoint: $bad", async ({ attempt, answer, words }) => {
      const relay = await startTestRelay();
      const bystander = await Bystander.at(relay);
      const target = { relay, robot: await relay.register(), other: bystander.robot };
      const outcome = await attempt?.(target);
      expect(outcome).toMatchObject({ answer, says: expect.stringContaining(words) });
      await bystander.drives();
    });
  });
}
