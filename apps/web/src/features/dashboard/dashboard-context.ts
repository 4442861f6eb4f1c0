/** What the parts of the dashboard share. */
import { createContext, useContext } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { ClassCalls, ClassRefusal } from "../../model/classroom/class-calls.ts";
import type { Dashboard, DashboardState } from "../../model/classroom/dashboard.ts";
import { studentNameText } from "../../model/classes/student-name.ts";
import type { SavedReports } from "../../model/teaching/saved-reports.ts";
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";

/** What the teacher notes about students, by their numbers. The texts stay on this device. */
export interface StudentNotes {
  /** empty: none */
  read: (student: number) => string;
  write: (student: number, text: string) => void;
}

export interface DashboardContent {
  /** of the class */
  id: string;
  dashboard: Dashboard;
  calls: ClassCalls;
  /** whether students are numbers */
  hidesNames: boolean;
  /** on this device */
  reports: SavedReports;
  notes: StudentNotes;
  /** Shows why a call had no effect. */
  report: (refusal: ClassRefusal | null) => void;
}

const Content = createContext<DashboardContent | null>(null);
export const DashboardProvider = Content.Provider;

export function useContent(): DashboardContent {
  const content = useContext(Content);
  if (content === null) throw new Error("This part is outside of the dashboard.");
  return content;
}

/** Renders again when the selected value changes. */
export function useDashboard<Value>(select: (state: DashboardState) => Value): Value {
  return useStore(useContent().dashboard.store, select);
}

/** Names students as the page shows them now. */
export function useStudentName(): (student: Pick<SeenStudent, "student" | "name">) => string {
  const { hidesNames } = useContent();
  const { t } = useTranslation("names", { useSuspense: false });
  const { t: tDashboard } = useTranslation("dashboard", { useSuspense: false });
  return ({ student, name }) =>
    hidesNames ? tDashboard("card.number", { number: student }) : studentNameText(t, name);
}
