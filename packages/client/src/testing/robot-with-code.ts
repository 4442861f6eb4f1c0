/** A robot at the real relay, a pairing code for it, and an owner who answers as the test says. */
import { createdPairingSchema, pairingSchema, type Registration } from "@corridor/protocol";
import { onTestFinished } from "vitest";
import { registerRobot } from "../register-robot.ts";
import { GridRobot } from "./grid-robot.ts";
import { startRelayProcess } from "./relay-process.ts";

export interface RobotWithCode {
  origin: string;
  registration: Registration;
  robot: GridRobot;
  code: string;
  /** Waits for the question, and says yes or no. */
  say: (accept: boolean) => Promise<void>;
}

export async function robotWithCode(maze: readonly string[]): Promise<RobotWithCode> {
  const { origin } = await startRelayProcess();
  const registration = await registerRobot(origin, fetch);
  const robot = new GridRobot(origin, registration, maze);
  onTestFinished(() => robot.link.close());
  const headers = {
    Authorization: `Bearer ${registration.ownerKey}`,
    "Content-Type": "application/json",
  };
  const own = async (method: string, query = "", body?: unknown): Promise<unknown> => {
    const got = await fetch(`${origin}/api/v1/robots/${registration.id}/pairing${query}`, {
      method,
      headers,
      ...(body !== undefined && { body: JSON.stringify(body) }),
    });
    return got.status === 204 ? null : got.json();
  };
  const { code } = createdPairingSchema.parse(await own("POST"));
  const say = async (accept: boolean): Promise<void> => {
    const { question } = pairingSchema.parse(await own("GET", "?wait=20"));
    await own("PUT", "", { id: question?.id, accept });
  };
  return { origin, registration, robot, code, say };
}
