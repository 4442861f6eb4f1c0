/**
 * Permissions of the user while a challenge is open. Without a challenge, everything is allowed.
 */
import {
  conditionKinds,
  MAX_RULES,
  menuActions,
  paperActions,
  type ConditionKind,
} from "@corridor/program";
import type { DriverName, PlainAction } from "@corridor/protocol";
import { conditionNameOf, type EditKind } from "./challenge-limits.ts";
import type { Task } from "./task-schema.ts";

export interface Rights {
  drivers: readonly DriverName[];
  /** maximum number of lines of a program */
  maxLines: number;
  /** entries of `conditionKinds`, in the menu's order */
  conditions: readonly ConditionKind[];
  /** entries of the menu, in its order; "stop" only if the challenge lists it */
  actions: readonly PlainAction[];
  edits: ReadonlySet<EditKind>;
  maze: boolean;
}

/** Returns the permissions of a task. */
export function rightsOf({ allowed }: Pick<Task, "allowed">): Rights {
  const { conditions, actions } = allowed;
  return {
    drivers: allowed.drivers,
    maxLines: Math.min(allowed.lines, MAX_RULES),
    conditions:
      conditions === null
        ? conditionKinds
        : conditionKinds.filter((kind) => conditions.includes(conditionNameOf(kind))),
    actions:
      actions === null ? paperActions : menuActions.filter((action) => actions.includes(action)),
    edits: new Set(allowed.edits),
    maze: allowed.maze,
  };
}
