import { createdPairingSchema, pairingSchema, type Registration } from "@corridor/protocol";
import { onTestFinished } from "vitest";
import { registerRobot } from "../../../packages/client/src/register-robot.ts";
import { GridRobot } from "./grid-robot.ts";

/** A robot at a real relay with a pairing code. */
export interface RobotWithCode {
  origin: string;
  registration: Registration;
  robot: GridRobot;
  code: string;
  /** Waits for a script's request, and accepts or refuses it as the owner. */
  answer: (accept: boolean) => Promise<void>;
}

/** @param origin of its relay */
export async function robotWithCode(
  origin: string,
  maze: readonly string[],
): Promise<RobotWithCode> {
  const registration = await registerRobot(origin, fetch);
  const robot = new GridRobot(origin, registration, maze);
  onTestFinished(() => robot.connection.close());
  const headers = {
    Authorization: `Bearer ${registration.ownerKey}`,
    "Content-Type": "application/json",
  };
  const pairing = async (method: string, query = "", body?: unknown): Promise<unknown> => {
    const response = await fetch(`${origin}/api/v1/robots/${registration.id}/pairing${query}`, {
      method,
      headers,
      ...(body !== undefined && { body: JSON.stringify(body) }),
    });
    return response.status === 204 ? null : response.json();
  };
  const { code } = createdPairingSchema.parse(await pairing("POST"));
  const answer = async (accept: boolean): Promise<void> => {
    const { question } = pairingSchema.parse(await pairing("GET", "?wait=20"));
    await pairing("PUT", "", { id: question?.id, accept });
  };
  return { origin, registration, robot, code, answer };
}
