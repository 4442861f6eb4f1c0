/** Opens this tab's repository in the storage of the device. */
import { WorldRepository, type WorldRepositoryPorts } from "./world-repository.ts";
import { openWorldStore } from "./world-store.ts";

export function openWorldRepository(
  ports: Omit<WorldRepositoryPorts, "openStore" | "newId" | "after">,
): WorldRepository {
  return new WorldRepository({
    ...ports,
    openStore: () => openWorldStore(Date.now),
    newId: () => crypto.getRandomValues(new Uint32Array(4)).join("-"),
    after: (milliseconds, call) => {
      const timer = setTimeout(call, milliseconds);
      return () => clearTimeout(timer);
    },
  });
}
