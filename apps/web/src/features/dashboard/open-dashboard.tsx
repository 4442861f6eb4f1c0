/** Opens the dashboard and starts its worker. */
import type { i18n } from "i18next";
import type { ReactNode } from "react";
import { ClassCalls } from "../../model/classroom/class-calls.ts";
import { Dashboard } from "../../model/classroom/dashboard.ts";
import type { OwnClass, OwnClasses } from "../../model/classroom/own-classes.ts";
import type { ProgramReader } from "../../model/classroom/program-reader.ts";
import type { SolutionVerifier } from "../../model/classroom/verifier.ts";
import type { SavedReports } from "../../model/teaching/saved-reports.ts";
import { studentNameText } from "../../model/classes/student-name.ts";
import type {
  ClassroomStatus,
  FromClassroom,
} from "../../simulator/protocol/classroom-messages.ts";
import { observeTheme, shownProperties } from "../../stage/page/observe-theme.ts";
import { readPalette } from "../../stage/drawing/palette.ts";
import { DashboardPage } from "./DashboardPage.tsx";

interface DashboardParts {
  room: OwnClass;
  classes: OwnClasses;
  reports: SavedReports;
  words: i18n;
  /** the buttons for theme and language */
  tools: ReactNode;
}

export function openDashboard({ room, classes, reports, words, tools }: DashboardParts): ReactNode {
  const worker = new Worker(
    new URL("../../simulator/classroom-worker/classroom.worker.ts", import.meta.url),
    { type: "module" },
  );
  const calls = new ClassCalls(room, (url, request) => fetch(url, request));
  const later = (call: () => void, ms: number): (() => void) => {
    const timer = setTimeout(call, ms);
    return () => clearTimeout(timer);
  };
  let verifier: Promise<SolutionVerifier> | null = null;
  const startVerifier = async (): Promise<SolutionVerifier> => {
    const [{ SolutionVerifier: Verifier }, { createWorkerPool }] = await Promise.all([
      import("../../model/classroom/verifier.ts"),
      import("../../simulator/worker-pool.ts"),
    ]);
    return new Verifier(createWorkerPool(), later, (each) => dashboard.verified(each));
  };
  let reader: Promise<ProgramReader> | null = null;
  const startReader = async (): Promise<ProgramReader> => {
    const { ProgramReader: Reader } = await import("../../model/classroom/program-reader.ts");
    return new Reader(calls, later, (programs) => dashboard.store.setState({ programs }));
  };
  const dashboard = new Dashboard({
    send: (message, transfer = []) => worker.postMessage(message, transfer),
    now: () => Date.now(),
    later,
    nameOf: ({ name }) => studentNameText(words.getFixedT(words.language, "names"), name),
    compareNames: (a, b) => a.localeCompare(b, words.language),
    readPrograms: (students) => {
      reader ??= startReader();
      reader.then(
        (each) => each.follow(students),
        // Its files did not load: the next edit tries again.
        () => (reader = null),
      );
    },
    verify: (lesson, students) => {
      verifier ??= startVerifier();
      verifier.then(
        (each) => each.follow(lesson, students),
        // Its files did not load: the next claim tries again.
        () => (verifier = null),
      );
    },
  });
  const followStatus = (kind: ClassroomStatus["kind"]): void => {
    // The service has deleted the class: its key is of no use any more.
    if (kind === "over") classes.remove(room.id);
    if (kind === "connected") classes.change(room.id, { key: room.key });
  };
  worker.onmessage = ({ data }: MessageEvent<FromClassroom>) => {
    dashboard.receive(data);
    if (data.type === "status") followStatus(data.status.kind);
  };
  const recolour = (): void =>
    dashboard.send({ type: "colours", palette: readPalette(shownProperties()) });
  recolour();
  observeTheme(recolour);
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  const calmDown = (): void => dashboard.send({ type: "calm", isCalm: calm.matches });
  calmDown();
  calm.addEventListener("change", calmDown);
  dashboard.send({ type: "open", room: { id: room.id, key: room.key } });
  window.addEventListener("online", () => dashboard.send({ type: "again" }));
  return (
    <DashboardPage
      dashboard={dashboard}
      calls={calls}
      reports={reports}
      room={room}
      notes={{
        read: (student) => classes.read(room.id)?.notes[student] ?? "",
        write: (student, text) => classes.setNote(room.id, student, text),
      }}
      onLabel={(label) => classes.change(room.id, { label })}
      tools={tools}
    />
  );
}
