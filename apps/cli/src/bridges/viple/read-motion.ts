/**
 * The messages of VIPLE: `{"servos":[{"servoId":3,"servoSpeed":0.5}]}`. Unknown fields and servos are
 * ignored.
 */
import { MAX_FRAME_BYTES, parseJson } from "@corridor/protocol";
import { VipleError } from "./viple-error.ts";

/** Servos by number; -1 or none: both. */
const LEFT = 3;
const RIGHT = 5;
const BOTH = -1;
/** The robot turns at most this far by one command. */
const MAX_DEGREES = 3_600;

/** Degrees to turn on the spot (negative: left), or powers of wheels from -1 to 1. */
export type ServoMotion = { degrees: number } | { left?: number; right?: number };

interface Servo {
  servoId: number;
  servoSpeed: number;
  /** null: not stated */
  isTurn: boolean | null;
}

/**
 * @returns what the servos of the message do, of which the last counts; null if it names none of them
 * @throws VipleError if the message cannot be read
 */
export function readMotion(text: string): ServoMotion | null {
  const parsed = parseJson(text, MAX_FRAME_BYTES);
  if (!parsed.ok || !isObject(parsed.value)) {
    throw new VipleError("A message of VIPLE is not one JSON object.");
  }
  const { servos = [] } = parsed.value;
  if (!Array.isArray(servos)) throw invalid("servos", servos, "a list");
  let motion: ServoMotion | null = null;
  for (const [at, value] of servos.entries()) {
    const next = motionOf(readServo(value, `servos[${at}]`), `servos[${at}]`);
    if (next === null) continue;
    motion = "degrees" in next ? next : { ...wheelsOf(motion), ...next };
  }
  return motion;
}

/** After a turn, both wheels stand. */
function wheelsOf(motion: ServoMotion | null): { left?: number; right?: number } {
  if (motion === null) return {};
  return "degrees" in motion ? { left: 0, right: 0 } : motion;
}

function readServo(value: unknown, path: string): Servo {
  if (!isObject(value)) throw invalid(path, value, "an object");
  const { servoId = BOTH, servoSpeed, isTurn = null } = value;
  if (!isNumber(servoId)) throw invalid(`${path}.servoId`, servoId, "a number");
  if (!isNumber(servoSpeed)) throw invalid(`${path}.servoSpeed`, servoSpeed, "a number");
  if (isTurn !== null && typeof isTurn !== "boolean") {
    throw invalid(`${path}.isTurn`, isTurn, "true or false");
  }
  return { servoId, servoSpeed, isTurn };
}

function motionOf({ servoId, servoSpeed, isTurn }: Servo, path: string): ServoMotion | null {
  if (servoId !== LEFT && servoId !== RIGHT && servoId !== BOTH) return null;
  const limit = isTurn === true ? MAX_DEGREES : 1;
  // VIPLE states that the whole robot does not turn, and sends only the direction.
  const speed = servoId === BOTH && isTurn === false ? Math.sign(servoSpeed) : servoSpeed;
  if (Math.abs(speed) > limit) {
    throw invalid(`${path}.servoSpeed`, speed, `a number from -${limit} to ${limit}`);
  }
  if (isTurn === true) return { degrees: speed };
  if (servoId === LEFT) return { left: speed };
  return servoId === RIGHT ? { right: speed } : { left: speed, right: speed };
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** A JSON text contains no NaN, but its numbers may be too large. */
function isNumber(value: unknown): value is number {
  return typeof value === "number" && Number.isFinite(value);
}

const MAX_FOUND = 40;

function invalid(path: string, found: unknown, expected: string): VipleError {
  const shown = found === undefined ? "nothing" : describe(found);
  return new VipleError(`A message of VIPLE has ${path} ${shown}, expected ${expected}.`);
}

function describe(value: unknown): string {
  if (Array.isArray(value)) return "a list";
  if (typeof value === "object" && value !== null) return "an object";
  return typeof value === "string" ? JSON.stringify(value.slice(0, MAX_FOUND)) : String(value);
}
