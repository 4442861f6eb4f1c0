import { describe, expect, it } from "vitest";
import { readSoundChoice } from "./sound-choice.ts";

describe("the stored choice of sounds", () => {
  it("is off until switched on, and quieter where less motion is asked for", () => {
    const first = readSoundChoice(null, false);
    expect(first).toMatchObject({ isOn: false, beam: "front" });
    const calm = readSoundChoice(null, true);
    expect(calm.isOn).toBe(false);
    expect(calm.volume).toBeLessThan(first.volume);
  });

  it("is read as it was stored", () => {
    const choice = { isOn: true, beam: null, volume: 0.2 };
    expect(readSoundChoice(JSON.stringify(choice), true)).toEqual(choice);
  });

  it("is off where it cannot be read, and within bounds", () => {
    for (const text of ["{", "7", "null", `"on"`, `{"isOn":"yes"}`]) {
      expect(readSoundChoice(text, false).isOn).toBe(false);
    }
    const odd = readSoundChoice(`{"isOn":true,"beam":"up","volume":7}`, false);
    expect(odd).toEqual({ isOn: true, beam: "front", volume: 0.6 });
  });
});
