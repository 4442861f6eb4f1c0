/** Announces who needs help now. */
import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { helpedOfState } from "../../model/classroom/dashboard.ts";
import { HelpAnnouncer } from "../../model/classroom/help-announcer.ts";
import { useContent, useStudentName } from "./dashboard-context.ts";

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
      return names.length === 0
        ? ""
        : t("announce", { count: names.length, names: names.join(", ") });
    };
  });
  useEffect(() => {
    const announcer = new HelpAnnouncer({
      announce: (students) => setText(say.current(students)),
      now: () => performance.now(),
      later: (call, ms) => {
        const timer = setTimeout(call, ms);
        return () => clearTimeout(timer);
      },
    });
    announcer.follow(helpedOfState(dashboard.store.getState()));
    const unsubscribe = dashboard.store.subscribe((state, before) => {
      if (state.shown !== before.shown) announcer.follow(helpedOfState(state));
    });
    return () => {
      unsubscribe();
      announcer.stop();
    };
  }, [dashboard]);
  return <output className="visually-hidden">{text}</output>;
}
