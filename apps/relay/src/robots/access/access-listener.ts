/** What the rest of a robot must know of changes of its permissions. */
import type {
  BlockResult,
  KeyChange,
  KeysResult,
  ScriptChange,
  StoredKey,
  StoredScript,
} from "../../commands/robot-step.ts";

export interface AccessListener {
  /** This relay has changed the keys. */
  keysChanged(): void;
  /** This relay has changed the permissions of scripts. */
  scriptsChanged(): void;
  /** Another relay may have changed the permissions, and they were read again. */
  reread(): void;
  /** A key is no longer valid. */
  revoked(key: StoredKey): void;
  /** A script was blocked. */
  blocked(script: StoredScript): void;
  /** Remote driving was paused. */
  paused(): void;
  /** The valid keys are unknown, because the store does not respond. */
  doubted(): void;
}

/** Changes stored permissions and recalls the affected commands, in the order of all changes. */
export interface PermissionChanges {
  changeKeys(change: KeyChange): Promise<KeysResult>;
  changeBlocked(change: ScriptChange): Promise<BlockResult>;
  /** @returns false if there is no such robot */
  pause(isPaused: boolean): Promise<boolean>;
  /** @returns false if there is no such robot */
  permitReset(mayReset: boolean): Promise<boolean>;
}
