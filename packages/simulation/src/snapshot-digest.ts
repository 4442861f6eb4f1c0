/**
 * A hash over all numbers of all snapshots, to verify that two engines produced the same bits.
 * 64 bits from two multiply-xor streams over the bits of the doubles. Not cryptographic.
 */
import type { RobotReport } from "@corridor/protocol";

export class SnapshotDigest {
  readonly #number = new Float64Array(1);
  readonly #words = new Uint32Array(this.#number.buffer);
  #a = 0x811c9dc5;
  #b = 0x9e3779b9;

  add(report: RobotReport): void {
    const { sensors, pose } = report;
    this.#mix(report.tick);
    this.#mix(sensors.front);
    this.#mix(sensors.right);
    this.#mix(sensors.back);
    this.#mix(sensors.left);
    this.#mix(pose.x);
    this.#mix(pose.y);
    this.#mix(pose.heading);
    this.#mix(report.bumps);
    this.#mix((report.bumping ? 1 : 0) + (report.goalReached ? 2 : 0));
    for (let i = 0; i < report.motion.length; i++) this.#mix(report.motion.charCodeAt(i));
  }

  /** Returns an independent copy. */
  clone(): SnapshotDigest {
    const copy = new SnapshotDigest();
    copy.#a = this.#a;
    copy.#b = this.#b;
    return copy;
  }

  /** Returns the current hash: 16 hexadecimal digits. */
  toString(): string {
    return hex(this.#a) + hex(this.#b);
  }

  #mix(value: number): void {
    this.#number[0] = value;
    for (const word of this.#words) {
      this.#a = Math.imul(this.#a ^ word, 0x01000193);
      this.#b = Math.imul((this.#b ^ word) + (this.#a >>> 15), 0x85ebca6b);
      this.#b ^= this.#b >>> 13;
    }
  }
}

function hex(word: number): string {
  return (word >>> 0).toString(16).padStart(8, "0");
}
