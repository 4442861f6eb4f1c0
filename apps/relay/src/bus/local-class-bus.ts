/**
 * Message bus for classes of a single relay. In tests, several relays of one process share one bus
 * and form a cluster.
 */
import { mintId } from "../platform/keys.ts";
import type { ClassBus, ClassChannel, ClassListener } from "./class-bus.ts";

export class LocalClassBus implements ClassBus {
  readonly #channels = new Map<string, Set<ClassListener>>();

  async join(id: string, listener: ClassListener): Promise<ClassChannel> {
    const members = this.#channels.get(id) ?? new Set<ClassListener>();
    this.#channels.set(id, members);
    members.add(listener);
    const name = mintId();
    const others = (): ClassListener[] => [...members].filter((other) => other !== listener);
    return {
      committed: (commit) => {
        for (const other of others()) other.committed(commit);
      },
      over: () => {
        for (const other of others()) other.over();
      },
      notify: (message) => {
        for (const other of others()) other.received(message, name);
      },
      leave: () => {
        members.delete(listener);
        if (members.size === 0 && this.#channels.get(id) === members) this.#channels.delete(id);
      },
    };
  }
}
