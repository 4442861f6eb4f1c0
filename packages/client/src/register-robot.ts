/** Asks the service for a robot: the page's first step before it opens its link. */
import { readJson, registrationSchema, type Registration } from "@corridor/protocol";
import type { Fetch } from "./platform.ts";

const MAX_ANSWER = 4_096;

/**
 * Registers a new robot.
 * @param origin of the service, such as https://robots.example.org
 * @throws Error when the service does not answer as it should, with a sentence for the user
 */
export async function registerRobot(origin: string, fetch: Fetch): Promise<Registration> {
  const answer = await fetch(`${origin}/api/v1/robots`, { method: "POST" });
  if (answer.status === 429) {
    throw new Error("Too many robots were registered from this network. Try again in a minute.");
  }
  if (answer.status !== 201) {
    throw new Error(`The service did not register the robot (status ${answer.status}).`);
  }
  const registration = readJson(registrationSchema, await answer.text(), MAX_ANSWER);
  if (registration.ok) return registration.value;
  throw new Error("The service answered the registration with something else. Reload the page.");
}
