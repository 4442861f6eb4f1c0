/**
 * Message bus for classes of a single relay. In tests, several relays of one process share one bus
 * and form a cluster.
 */
import { mintId } from "../platform/keys.ts";
import type { ClassBus, ClassChannel, ClassListener } from "./class-bus.ts";

export class LocalClassBus implements ClassBus {
  readonly #channels = new Map<string, Map<string, ClassListener>>();

  async join(id: string, listener: ClassListener): Promise<ClassChannel> {
    const members = this.#channels.get(id) ?? new Map<string, ClassListener>();
    this.#channels.set(id, members);
    const self = mintId();
    members.set(self, listener);
    const others = () => [...members].filter(([name]) => name !== self);
    const leave = (): void => {
      if (!members.delete(self)) return;
      for (const [, other] of members) other.received({ kind: "left" }, self);
      if (members.size === 0 && this.#channels.get(id) === members) this.#channels.delete(id);
    };
    return {
      committed: (news) => {
        for (const [, other] of others()) other.news(news);
      },
      notify: (message) => {
        for (const [, other] of others()) other.received(message, self);
      },
      leave,
    };
  }
}
