import { readJson, registrationSchema, type Registration } from "@corridor/protocol";
import type { Fetch } from "./platform.ts";

const MAX_RESPONSE = 4_096;

/** A failed registration. `code` is stable, the message is for logs. */
export class RegistrationError extends Error {
  override readonly name = "RegistrationError";
  /** `noService`: another server responds at this address; `noAnswer`: no server responds */
  readonly code: "tooManyRobots" | "noService" | "noAnswer" | "refused";

  constructor(code: RegistrationError["code"], message: string, options?: ErrorOptions) {
    super(message, options);
    this.code = code;
  }
}

/**
 * Registers a new robot.
 * @param origin of the service, such as https://robots.example.org
 * @throws RegistrationError
 */
export async function registerRobot(origin: string, fetch: Fetch): Promise<Registration> {
  const response = await post(`${origin}/api/v1/robots`, fetch);
  const { status } = response;
  if (status === 429) {
    throw new RegistrationError(
      "tooManyRobots",
      "Too many robots were registered from this network. Try again in a minute.",
    );
  }
  if (status !== 201) {
    // The statuses of static file servers.
    const isFileServer = status === 404 || status === 405 || status === 501;
    throw new RegistrationError(
      isFileServer ? "noService" : "refused",
      `The service did not register the robot (status ${status}). Try again in a minute.`,
    );
  }
  const registration = readJson(registrationSchema, await response.text(), MAX_RESPONSE);
  if (registration.ok) return registration.value;
  throw new RegistrationError(
    "noService",
    "The service sent an unexpected response to the registration. Reload the page.",
  );
}

async function post(url: string, fetch: Fetch): ReturnType<Fetch> {
  try {
    return await fetch(url, { method: "POST" });
  } catch (cause) {
    throw new RegistrationError(
      "noAnswer",
      `No server responds at ${url}. Check the network and that the service runs.`,
      { cause },
    );
  }
}
