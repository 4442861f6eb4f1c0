/** Asks the service for a robot: the page's first step before it opens its link. */
import { readJson, registrationSchema, type Registration } from "@corridor/protocol";
import type { Fetch } from "./platform.ts";

const MAX_ANSWER = 4_096;

/** Why no robot was registered; `code` is stable, the message is a sentence for who reads logs. */
export class RegistrationError extends Error {
  override readonly name = "RegistrationError";
  /** `noService`: something else than the service answers at this address; `noAnswer`: nothing does */
  readonly code: "tooManyRobots" | "noService" | "noAnswer" | "refused";

  constructor(code: RegistrationError["code"], message: string, options?: ErrorOptions) {
    super(message, options);
    this.code = code;
  }
}

/**
 * Registers a new robot.
 * @param origin of the service, such as https://robots.example.org
 * @throws RegistrationError when the service does not answer as it should
 */
export async function registerRobot(origin: string, fetch: Fetch): Promise<Registration> {
  const answer = await ask(`${origin}/api/v1/robots`, fetch);
  const { status } = answer;
  if (status === 429) {
    throw new RegistrationError(
      "tooManyRobots",
      "Too many robots were registered from this network. Try again in a minute.",
    );
  }
  if (status !== 201) {
    // A server of files alone answers so.
    const isFileServer = status === 404 || status === 405 || status === 501;
    throw new RegistrationError(
      isFileServer ? "noService" : "refused",
      `The service did not register the robot (status ${status}). Try again in a minute.`,
    );
  }
  const registration = readJson(registrationSchema, await answer.text(), MAX_ANSWER);
  if (registration.ok) return registration.value;
  throw new RegistrationError(
    "noService",
    "The service answered the registration with something else. Reload the page.",
  );
}

async function ask(url: string, fetch: Fetch): ReturnType<Fetch> {
  try {
    return await fetch(url, { method: "POST" });
  } catch (cause) {
    throw new RegistrationError(
      "noAnswer",
      `Nothing answers at ${url}. Check the network and that the service runs.`,
      { cause },
    );
  }
}
