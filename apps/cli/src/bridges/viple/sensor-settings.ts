/** Which readings of the robot VIPLE receives, under which names and numbers, and in which unit. */
import { sensorNames, type SensorName, type Snapshot } from "@corridor/protocol";
import { InputError } from "../../input-error.ts";

const TOUCH = "touch";
/** The names of sensors in VIPLE. */
const names = [TOUCH, "distance", "sound", "light", "color", "motorEncoder"];
/** One unit in cm. */
const units: Readonly<Record<string, number>> = { mm: 0.1, cm: 1, inch: 2.54, m: 100 };
/** Digits of a distance after the point. */
const DIGITS = 3;

export interface SensorSettings {
  sensors: readonly VipleSensor[];
  /** one unit of distances, in cm */
  unit: number;
}

interface VipleSensor {
  source: SensorName | typeof TOUCH;
  name: string;
  /** the port number in the diagram */
  id: number;
}

/** Options for `bridgeArguments`. */
export const sensorOptions = {
  sensor: { type: "string", multiple: true },
  unit: { type: "string", default: "cm" },
} as const;

/** Lines of the help text for `sensorOptions`. */
export const sensorHelp = `  --sensor SIDE=[NAME:]ID  a sensor of the diagram: SIDE is front, right, back, left or touch, NAME
                           is distance or another name in VIPLE, ID is its port number. Give it once
                           for each sensor; default: touch=0, right=1, front=2
  --unit UNIT              unit of distances: mm, cm, inch or m; default: cm`;

/** The numbers of VIPLE's Unity simulator. */
const defaults = ["touch=0", "right=1", "front=2"];

/** @throws InputError */
export function readSensorSettings({
  sensor: texts = defaults,
  unit: unitName,
}: {
  sensor?: readonly string[] | undefined;
  unit: string;
}): SensorSettings {
  const unit = Object.hasOwn(units, unitName) ? units[unitName] : undefined;
  if (unit === undefined) {
    const expected = Object.keys(units).join(", ");
    throw new InputError([
      `--unit: found ${JSON.stringify(unitName)}, expected one of ${expected}`,
    ]);
  }
  return { sensors: texts.map((text) => readSensor(text)), unit };
}

function readSensor(text: string): VipleSensor {
  const match = /^(\w+)=(?:(\w+):)?(\d{1,9})$/.exec(text);
  const [, side, givenName, id] = match ?? [];
  const source = [...sensorNames, TOUCH].find(
    (each): each is VipleSensor["source"] => each === side,
  );
  const name = givenName ?? (source === TOUCH ? TOUCH : "distance");
  if (source === undefined || !names.includes(name) || (source === TOUCH) !== (name === TOUCH)) {
    throw new InputError([
      `--sensor: found ${JSON.stringify(text)}, expected a side and a port number, such as front=2 or left=sound:3`,
    ]);
  }
  return { source, name, id: Number(id) };
}

/** The message with the readings. All values are numbers. */
export function sensorMessage(
  { sensors, bumping }: Pick<Snapshot, "sensors" | "bumping">,
  settings: SensorSettings,
): string {
  const values = settings.sensors.map(({ source, name, id }) => ({
    name,
    id,
    value: source === TOUCH ? Number(bumping) : rounded(sensors[source] / settings.unit),
  }));
  return JSON.stringify({ sensors: values });
}

function rounded(value: number): number {
  return Number(value.toFixed(DIGITS));
}
