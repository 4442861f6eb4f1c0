/** The commands of scripts that the Remote panel lists. Beyond a limit, the oldest are removed. */
import { hasEnded, type DeliveredCommand } from "@corridor/protocol";
import type { ListedCommand } from "../protocol/worker-messages.ts";

const MAX_LISTED = 100;

export class CommandList {
  /** by seq */
  readonly #commands = new Map<number, ListedCommand>();

  /** Highest listed seq; 0 without commands. */
  get newestSeq(): number {
    return Math.max(0, ...this.#commands.keys());
  }

  /** All commands, newest first. */
  toArray(): ListedCommand[] {
    return [...this.#commands.values()].toSorted((a, b) => b.seq - a.seq);
  }

  get(seq: number): ListedCommand | undefined {
    return this.#commands.get(seq);
  }

  /** Adds a command, or replaces it. */
  set(command: ListedCommand): void {
    this.#commands.set(command.seq, command);
    if (this.#commands.size > MAX_LISTED) this.#commands.delete(Math.min(...this.#commands.keys()));
  }

  /** Adds a command that the relay has delivered. */
  deliver({ seq, key, command, acceptedAt, ttl }: DeliveredCommand): void {
    this.set({
      seq,
      key,
      action: command.action,
      command,
      state: "delivered",
      reason: null,
      acceptedAt,
      pose: null,
      distance: null,
      duplicate: false,
      ttl,
    });
  }

  /** Changes a command if it is listed. */
  change(seq: number, change: Partial<ListedCommand>): void {
    const command = this.#commands.get(seq);
    if (command !== undefined) this.#commands.set(seq, { ...command, ...change });
  }

  /** Delivered commands are queued at the relay again. */
  returnDelivered(): void {
    for (const [seq, { state }] of this.#commands) {
      if (state === "delivered") this.change(seq, { state: "accepted" });
    }
  }

  removeEnded(): void {
    for (const [seq, { state }] of this.#commands) {
      if (hasEnded(state)) this.#commands.delete(seq);
    }
  }

  clear(): void {
    this.#commands.clear();
  }
}
