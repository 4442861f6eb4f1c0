/** What a robot's owner permits: its keys, and the scripts that are blocked. */
import type { RobotCommands, AdmissionState, TermedRecord } from "./robot-commands.ts";
import type {
  RobotStep,
  BlockResult,
  KeyChange,
  KeysResult,
  Permissions,
  ScriptChange,
  StoredKey,
  StoredScript,
} from "./robot-step.ts";
import { recallAllOf } from "./state-machine.ts";

/**
 * Creates and revokes keys, and recalls the commands of revoked ones. Their scripts are no longer
 * blocked, because they cannot return.
 * @returns what exists now, and the hashes of the revoked keys; null if there are too many
 */
export function changeKeys(
  robot: RobotCommands,
  before: Permissions,
  { add, remove, removeKind, most }: KeyChange,
): (Permissions & { revoked: string[]; ended: TermedRecord[] }) | null {
  const isRevoked = ({ hash, kind, use }: StoredKey): boolean =>
    remove.includes(hash) || (kind === removeKind?.kind && use === removeKind.use);
  const keys = [...before.keys.filter((key) => !isRevoked(key)), ...add];
  if (add.length > 0 && keys.length > most) return null;
  const revoked = before.keys.filter(isRevoked).map(({ hash }) => hash);
  const blocked = before.blocked.filter(({ driver }) => !revoked.includes(driver));
  Object.assign(robot.admissionState, admissionStateOf({ keys, blocked }));
  const ended = revoked.flatMap((driver) => recallAllOf(robot, { driver }, "revoked"));
  return { keys, blocked, revoked, ended };
}

/** What of the permissions decides whether a command is accepted. */
export function admissionStateOf({
  keys,
  blocked,
}: Permissions): Pick<AdmissionState, "keys" | "blocked"> {
  return {
    keys: new Set(keys.map(({ hash }) => hash)),
    blocked: new Set(blocked.map(({ id }) => id)),
  };
}

/**
 * Blocks a script and recalls its commands, or unblocks one.
 * @returns the blocked scripts; null if there are too many
 */
export function changeBlocked(
  robot: RobotCommands,
  all: readonly StoredScript[],
  { add, remove, most }: ScriptChange,
): { blocked: StoredScript[]; ended: TermedRecord[] } | null {
  const blocked = all.filter(({ id }) => id !== remove);
  if (add !== null && !blocked.some(({ id }) => id === add.id)) {
    if (blocked.length >= most) return null;
    blocked.push(add);
  }
  robot.admissionState.blocked = new Set(blocked.map(({ id }) => id));
  const ended = add === null ? [] : recallAllOf(robot, { script: add.id }, "blocked");
  return { blocked, ended };
}

/** Permits or forbids scripts to reset the robot. @returns false if there is no such robot */
export function permitResetStep(mayReset: boolean): RobotStep<boolean> {
  return {
    none: false,
    changesRobot: true,
    apply: ({ commands }) => {
      commands.admissionState.mayReset = mayReset;
      return true;
    },
  };
}

/** Creates and revokes keys. Keys can be revoked on a full disk. */
export function changeKeysStep(change: KeyChange): RobotStep<KeysResult> {
  return {
    none: { outcome: "no-robot" },
    changesRobot: true,
    needsSpace: change.add.length > 0,
    apply: (robot) => {
      const before = robot.permissions;
      const changed = changeKeys(robot.commands, before, change);
      if (changed === null) return { outcome: "full" };
      const { keys, blocked, revoked, ended } = changed;
      robot.setKeys({ keys, added: change.add, revoked, now: change.now });
      if (blocked.length < before.blocked.length) robot.setBlocked(blocked);
      return { outcome: "changed", keys, ended };
    },
  };
}

/**
 * Blocks a script, or unblocks one. Blocking is idempotent, and possible on a full disk, because the
 * number of blocked scripts is limited.
 */
export function changeBlockedStep(change: ScriptChange): RobotStep<BlockResult> {
  return {
    none: { outcome: "no-robot" },
    changesRobot: true,
    apply: (robot) => {
      const changed = changeBlocked(robot.commands, robot.permissions.blocked, change);
      if (changed === null) return { outcome: "full" };
      robot.setBlocked(changed.blocked);
      return { outcome: "changed", ...changed };
    },
  };
}
