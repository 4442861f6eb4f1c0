/** Makes the sounds with Web Audio: short tones with soft ends, no files. */
import type { SoundPort } from "./sound-plan.ts";

/** Maximum gain of all sounds together. They accompany, and never startle. */
const LOUDEST = 0.25;
/** Seconds in which a tone rises. Without the rise, each tone would start with a click. */
const ATTACK = 0.005;

interface Tone {
  hertz: number;
  /** pitch at the end; constant by default */
  toHertz?: number;
  /** seconds from now */
  after?: number;
  seconds: number;
  gain: number;
  shape: OscillatorType;
}

export class Synth implements SoundPort {
  readonly #context: AudioContext;
  readonly #master: GainNode;

  constructor(context: AudioContext) {
    this.#context = context;
    this.#master = context.createGain();
    this.#master.connect(context.destination);
  }

  /** @param volume 0 to 1 */
  set volume(volume: number) {
    // Steps of the squared volume sound even.
    this.#master.gain.value = LOUDEST * volume * volume;
  }

  tick(): void {
    this.#play({ hertz: 1800, seconds: 0.03, gain: 0.5, shape: "sine" });
  }

  note(hertz: number): void {
    this.#play({ hertz, seconds: 0.12, gain: 0.8, shape: "triangle" });
  }

  bump(): void {
    this.#play({ hertz: 130, toHertz: 55, seconds: 0.25, gain: 1, shape: "triangle" });
  }

  goal(): void {
    for (const [at, hertz] of [523, 659, 784].entries()) {
      this.#play({ hertz, after: 0.13 * at, seconds: 0.3, gain: 0.8, shape: "triangle" });
    }
  }

  #play({ hertz, toHertz = hertz, after = 0, seconds, gain, shape }: Tone): void {
    const context = this.#context;
    const from = context.currentTime + after;
    const until = from + seconds;
    const oscillator = context.createOscillator();
    oscillator.type = shape;
    oscillator.frequency.setValueAtTime(hertz, from);
    oscillator.frequency.exponentialRampToValueAtTime(toHertz, until);
    const envelope = context.createGain();
    envelope.gain.setValueAtTime(0, from);
    envelope.gain.linearRampToValueAtTime(gain, from + ATTACK);
    envelope.gain.exponentialRampToValueAtTime(0.001, until);
    oscillator.connect(envelope).connect(this.#master);
    oscillator.start(from);
    oscillator.stop(until);
  }
}
