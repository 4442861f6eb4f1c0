/**
 * Message bus for classes of a single relay. In tests, several relays of one process share one bus
 * and form a cluster.
 */
import type { ClassBus, ClassChannel, ClassListener } from "./class-bus.ts";

export class LocalClassBus implements ClassBus {
  readonly #channels = new Map<string, Set<ClassListener>>();

  async join(id: string, listener: ClassListener): Promise<ClassChannel> {
    const members = this.#channels.get(id) ?? new Set<ClassListener>();
    this.#channels.set(id, members);
    members.add(listener);
    const others = (): ClassListener[] => [...members].filter((other) => other !== listener);
    return {
      committed: (news) => {
        for (const other of others()) other.news(news);
      },
      over: () => {
        for (const other of others()) other.over();
      },
      leave: () => {
        members.delete(listener);
        if (members.size === 0 && this.#channels.get(id) === members) this.#channels.delete(id);
      },
    };
  }
}
