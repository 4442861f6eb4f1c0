/** The connection of a member, as the class uses it. */
export interface MemberConnection<M> {
  send(message: M): void;
  close(reason: LeaveReason): void;
}

/**
 * removed: by the teacher. replaced: another tab or device is the student now. over: the class has
 * ended.
 */
export type LeaveReason = "removed" | "replaced" | "over";
