/**
 * The sounds of the page: the settings, stored on the device, and the player. Sound is off until
 * the student switches it on. Browsers require a press or a key first, so a page that opens with
 * sound on waits for one.
 */
import type { SensorName } from "@corridor/protocol";
import { createStore } from "zustand/vanilla";
import { storageOrNone } from "../../model/storage/key-value-storage.ts";
import type { RunStore } from "../../model/run/run-store.ts";
import { readSoundChoice, SOUND_KEY, type SoundChoice } from "./sound-choice.ts";
import { SoundPlan } from "./sound-plan.ts";
import { Synth } from "./synth.ts";

/** Milliseconds between two checks for a due tick, much less than the shortest gap. */
const LOOK_MS = 20;

export class Sounds {
  readonly choice;
  readonly #run: RunStore;
  #synth: Synth | null = null;
  #context: AudioContext | null = null;
  #plan: SoundPlan | null = null;

  constructor(run: RunStore) {
    this.#run = run;
    const device = storageOrNone(() => localStorage);
    const isCalm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.choice = createStore<SoundChoice>()(() =>
      readSoundChoice(device.getItem(SOUND_KEY), isCalm),
    );
    this.choice.subscribe((choice) => {
      try {
        device.setItem(SOUND_KEY, JSON.stringify(choice));
      } catch {
        // The settings then last until the student leaves the page.
      }
      this.#apply();
    });
  }

  /**
   * Call it in a press handler, so that the browser permits sound at once.
   * @returns false without Web Audio
   */
  switchOn(): boolean {
    if (!this.#open()) return false;
    this.choice.setState({ isOn: true });
    return true;
  }

  switchOff(): void {
    this.choice.setState({ isOn: false });
    void this.#context?.suspend();
  }

  setBeam(beam: SensorName | null): void {
    this.choice.setState({ beam });
  }

  /** @param volume 0 to 1 */
  setVolume(volume: number): void {
    this.choice.setState({ volume });
    this.#synth?.tick();
  }

  /** If the stored settings are on, sound starts with the first press or key. */
  resume(): void {
    if (!this.choice.getState().isOn) return;
    const begin = () => {
      window.removeEventListener("pointerdown", begin);
      window.removeEventListener("keydown", begin);
      if (this.choice.getState().isOn) this.#open();
    };
    window.addEventListener("pointerdown", begin);
    window.addEventListener("keydown", begin);
  }

  #open(): boolean {
    if (!("AudioContext" in globalThis)) return false;
    if (this.#context === null) {
      const context = new AudioContext();
      this.#context = context;
      this.#synth = new Synth(context);
      const plan = new SoundPlan(this.#synth, () => performance.now());
      this.#plan = plan;
      this.#run.subscribe(({ snapshot, view }, before) => {
        if (snapshot === before.snapshot || snapshot === null) return;
        if (this.choice.getState().isOn) plan.show(snapshot, view);
      });
      setInterval(() => {
        if (plan.isRunning && this.choice.getState().isOn) plan.advance();
      }, LOOK_MS);
      const { snapshot, view } = this.#run.getState();
      if (snapshot !== null) plan.show(snapshot, view);
    }
    void this.#context.resume();
    this.#apply();
    return true;
  }

  #apply(): void {
    const { beam, volume } = this.choice.getState();
    if (this.#plan !== null) this.#plan.beam = beam;
    if (this.#synth !== null) this.#synth.volume = volume;
  }
}

let sounds: Sounds | null = null;

/** The sounds of this page. */
export function soundsOf(run: RunStore): Sounds {
  sounds ??= new Sounds(run);
  return sounds;
}
