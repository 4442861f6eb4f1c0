/** What the page of a student receives about its class. Pure. */
import { PROTOCOL_VERSION, type RelayToStudent } from "@corridor/protocol";
import type { StudentRow } from "../store/class-store.ts";
import { nameOf, settingsOf, type ClassState } from "./class-state.ts";

/** The first message of a connection. */
export function welcomeOf(
  { row }: ClassState,
  student: StudentRow,
  { watched, now }: { watched: boolean; now: number },
): RelayToStudent {
  const { pauseEndsInMs, paceTo, lesson } = settingsOf(row, now);
  return {
    type: "welcome",
    version: PROTOCOL_VERSION,
    student: student.student,
    name: nameOf(row, student),
    renamesLeft: student.renamesLeft,
    progress: student.progress,
    helpWanted: student.helpSince !== null,
    watched,
    pauseEndsInMs,
    paceTo,
    lesson,
  };
}

/** The messages about what has changed for a student since an earlier state. */
export function changesFor(
  student: StudentRow,
  { row }: ClassState,
  before: ClassState,
  now: number,
): RelayToStudent[] {
  const { pauseEndsInMs } = settingsOf(row, now);
  const { renamesLeft, name } = student;
  const changes: [hasChanged: boolean, message: RelayToStudent][] = [
    [
      name !== before.students.get(student.student)?.name,
      { type: "name", name: nameOf(row, student), renamesLeft },
    ],
    [
      row.lessonVersion !== before.row.lessonVersion,
      { type: "lesson", version: row.lessonVersion },
    ],
    [row.pause?.endsAt !== before.row.pause?.endsAt, { type: "pause", endsInMs: pauseEndsInMs }],
    [row.paceTo !== before.row.paceTo, { type: "pace", to: row.paceTo }],
  ];
  return changes.filter(([hasChanged]) => hasChanged).map(([, message]) => message);
}
