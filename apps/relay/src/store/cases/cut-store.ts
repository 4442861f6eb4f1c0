/** A store with simulated failures: before a step, or after it, so that its result is lost. */
import type { RobotStore } from "../robot-store.ts";
import { StoreUnavailableError } from "../../platform/errors/store-unavailable.ts";

export interface CutStore {
  store: RobotStore;
  isCut: boolean;
  losesAnswers: boolean;
}

export function cutStore(whole: RobotStore): CutStore {
  const cut: CutStore = { store: whole, isCut: false, losesAnswers: false };
  cut.store = new Proxy(whole, {
    get(target, name) {
      const part: unknown = Reflect.get(target, name);
      if (typeof part !== "function") return part;
      // Needs no connection.
      if (name === "current") return part.bind(target) as unknown;
      return async (...values: unknown[]): Promise<unknown> => {
        if (cut.isCut) throw new StoreUnavailableError("it was cut off");
        const answer: unknown = await Reflect.apply(part, target, values);
        if (cut.losesAnswers) throw new StoreUnavailableError("its answer was lost");
        return answer;
      };
    },
  });
  return cut;
}
