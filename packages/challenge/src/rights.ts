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
import {
  conditionNameOf,
  helpKinds,
  toolNames,
  type EditKind,
  type HelpKind,
  type ToolName,
} from "./challenge-limits.ts";
import type { LessonTask } from "./lesson-document.ts";
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
  /** tools that the page shows */
  tools: ReadonlySet<ToolName>;
  /** help that the page gives */
  help: ReadonlySet<HelpKind>;
}

/** Permissions of a task of either version. */
type Allowed = Task["allowed"] & Partial<Pick<LessonTask["allowed"], "tools" | "help">>;

/** Returns the permissions of a task. */
export function rightsOf({ allowed }: { allowed: Allowed }): Rights {
  const { conditions, actions } = allowed;
  const tools = new Set(allowed.tools ?? toolNames);
  // The only driver cannot be hidden, and one that the task does not allow is not shown.
  if (allowed.drivers.every((driver) => driver === "remote")) tools.add("remote");
  if (!allowed.drivers.includes("remote")) tools.delete("remote");
  return {
    drivers: allowed.drivers.filter((driver) => driver !== "remote" || tools.has("remote")),
    maxLines: Math.min(allowed.lines, MAX_RULES),
    conditions:
      conditions === null
        ? conditionKinds
        : conditionKinds.filter((kind) => conditions.includes(conditionNameOf(kind))),
    actions:
      actions === null ? paperActions : menuActions.filter((action) => actions.includes(action)),
    edits: new Set(allowed.edits),
    maze: allowed.maze,
    tools,
    // Changes that solve the task are shown only where a task lists them.
    help: new Set(allowed.help ?? helpKinds.filter((kind) => kind !== "fixes")),
  };
}
