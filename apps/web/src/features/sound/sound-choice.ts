/** The sound settings of a student, as the device stores them. */
import { sensorNames, type SensorName } from "@corridor/protocol";

export const SOUND_KEY = "corridor.sound";

export interface SoundChoice {
  isOn: boolean;
  /** the beam to listen to; null: none */
  beam: SensorName | null;
  /** 0 to 1 */
  volume: number;
}

const VOLUME = 0.6;
/** Initial volume on devices that prefer reduced motion. */
const CALM_VOLUME = 0.4;

/** Reads the stored settings. Unreadable text counts as none, which means that sound is off. */
export function readSoundChoice(stored: string | null, isCalm: boolean): SoundChoice {
  const none: SoundChoice = { isOn: false, beam: "front", volume: isCalm ? CALM_VOLUME : VOLUME };
  let value: unknown;
  try {
    value = JSON.parse(stored ?? "null");
  } catch {
    return none;
  }
  if (value === null || typeof value !== "object") return none;
  const { isOn, beam, volume } = value as Partial<Record<keyof SoundChoice, unknown>>;
  return {
    isOn: isOn === true,
    beam: beam === null ? null : (sensorNames.find((name) => name === beam) ?? none.beam),
    volume: typeof volume === "number" && volume >= 0 && volume <= 1 ? volume : none.volume,
  };
}
