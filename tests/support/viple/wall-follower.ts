/**
 * A diagram of VIPLE that follows the right wall, as a script: it knows only the messages with readings,
 * and sends motions once. The sensors have the numbers of VIPLE's Unity simulator.
 */

/** Of full power, so that the robot drives at most some cm between a reading and a motion. */
const POWER = 0.3;
/** cm from the centre of the robot: the side is open. */
const OPEN = 100;
/** cm from the centre of the robot: a wall ahead. */
const NEAR = 58;
/** cm from the edge of an opening to the middle of its cell, without those driven meanwhile. */
const TO_MIDDLE = 42;

interface Readings {
  right: number;
  front: number;
}

type State =
  | { name: "follow" }
  /** the right side is open; `front` was read at its edge */
  | { name: "opening"; front: number }
  /** until the robot stands; then it drives, and `next` counts */
  | { name: "turn"; next: "follow" | "leave" }
  /** leaves the cell in which it has turned right */
  | { name: "leave" };

export class WallFollower {
  readonly #send: (message: object) => void;
  #state: State = { name: "follow" };
  #last = "";
  #hasBegun = false;
  /** number of turns to the left and to the right */
  readonly turns = { left: 0, right: 0 };

  /** @param send sends a message to the robot */
  constructor(send: (message: object) => void) {
    this.#send = send;
  }

  /** A message with readings arrives. */
  receive(text: string): void {
    const isSame = text === this.#last;
    this.#last = text;
    if (!this.#hasBegun) {
      this.#hasBegun = true;
      return this.#drive(POWER);
    }
    const readings = readingsIn(text);
    const state = this.#state;
    switch (state.name) {
      case "follow":
        if (readings.right > OPEN) this.#state = { name: "opening", front: readings.front };
        else if (readings.front < NEAR) this.#turn(-90);
        return;
      case "opening":
        if (readings.front < Math.max(NEAR, state.front - TO_MIDDLE)) this.#turn(90);
        return;
      case "turn":
        if (!isSame) return;
        this.#state = { name: state.next };
        if (readings.front < NEAR) return this.#turn(-90);
        return this.#drive(POWER);
      case "leave":
        if (readings.right < OPEN) this.#state = { name: "follow" };
        else if (readings.front < NEAR) this.#turn(-90);
    }
  }

  #drive(power: number): void {
    const servos = [3, 5].map((servoId) => ({ servoId, servoSpeed: power }));
    this.#send({ servos });
  }

  #turn(degrees: 90 | -90): void {
    this.turns[degrees < 0 ? "left" : "right"] += 1;
    this.#state = { name: "turn", next: degrees < 0 ? "follow" : "leave" };
    this.#send({ servos: [{ servoId: -1, servoSpeed: degrees, isTurn: true }] });
  }
}

function readingsIn(text: string): Readings {
  const { sensors } = JSON.parse(text) as {
    sensors: { name: string; id: number; value: number }[];
  };
  const distance = (number: number): number =>
    sensors.find(({ name, id }) => name === "distance" && id === number)?.value ?? Number.NaN;
  return { right: distance(1), front: distance(2) };
}
