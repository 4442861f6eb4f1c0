/** Announces who needs help now: at most once in 10 s. */
import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { helpedOfState } from "../../model/classroom/dashboard.ts";
import { useContent, useStudentName } from "./dashboard-context.ts";

const INTERVAL_MS = 10_000;

export function Announcements() {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { dashboard } = useContent();
  const nameOf = useStudentName();
  const [text, setText] = useState("");
  const say = useRef<(students: readonly number[]) => string>(() => "");
  useEffect(() => {
    say.current = (numbers) => {
      const { students } = dashboard.store.getState();
      const names = numbers.flatMap((number) => {
        const student = students.get(number);
        return student === undefined ? [] : [nameOf(student)];
      });
      return t("announce", { count: names.length, names: names.join(", ") });
    };
  });
  useEffect(() => {
    let known: ReadonlySet<number> = new Set();
    const timer = setInterval(() => {
      const helped = helpedOfState(dashboard.store.getState());
      const added = [...helped].filter((student) => !known.has(student));
      known = helped;
      setText(added.length === 0 ? "" : say.current(added));
    }, INTERVAL_MS);
    return () => clearInterval(timer);
  }, [dashboard]);
  return <output className="visually-hidden">{text}</output>;
}
