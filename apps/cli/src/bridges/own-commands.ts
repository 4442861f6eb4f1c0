/** The commands of a bridge that have not ended: it ends them when it stops, so that the robot stands. */
import { hasEnded, type CommandRecord, type EventGap, type Order } from "@corridor/protocol";

/** What a command belongs to, such as a connection. */
type Owner = object;

interface OwnCommand {
  owner: Owner;
  order: Order;
  /** null until it is stored */
  seq: number | null;
  /** resolves once it is stored or refused */
  stored: Promise<void>;
}

export class OwnCommands {
  /** by idempotency key, because a state may precede the answer that contains the number */
  readonly #open = new Map<string, OwnCommand>();

  /** @param sent resolves with the record, once the command is stored */
  add(
    { owner, order, key }: { owner: Owner; order: Order; key: string },
    sent: Promise<CommandRecord>,
  ): void {
    const stored = sent.then(
      ({ seq, state }) => {
        const command = this.#open.get(key);
        if (command !== undefined) command.seq = seq;
        if (hasEnded(state)) this.#open.delete(key);
      },
      () => void this.#open.delete(key),
    );
    this.#open.set(key, { owner, order, seq: null, stored });
  }

  /** A command of any script has changed. */
  state({ key, state }: CommandRecord): void {
    if (key !== null && hasEnded(state)) this.#open.delete(key);
  }

  /** States were missed: all commands have ended except these. */
  gap(open: EventGap["open"]): void {
    const seqs = new Set(open.map(({ seq }) => seq));
    for (const [key, { seq }] of this.#open) {
      if (seq !== null && !seqs.has(seq)) this.#open.delete(key);
    }
  }

  /** @returns the numbers of all open commands of an owner, once those being sent are stored */
  async seqsOf(owner: Owner, isMeant: (order: Order) => boolean): Promise<number[]> {
    return this.#seqs((command) => command.owner === owner && isMeant(command.order));
  }

  /** @returns the numbers of all open commands, once those being sent are stored */
  async all(): Promise<number[]> {
    return this.#seqs(() => true);
  }

  async #seqs(isMeant: (command: OwnCommand) => boolean): Promise<number[]> {
    const found = [...this.#open.values()].filter((command) => isMeant(command));
    await Promise.all(found.map(({ stored }) => stored));
    return found.flatMap(({ seq }) => (seq === null ? [] : [seq]));
  }
}
