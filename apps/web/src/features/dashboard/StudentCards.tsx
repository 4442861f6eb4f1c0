/** The students, by what they need. */
import { useEffect, useRef, useState } from "react";
import { flushSync } from "react-dom";
import { useTranslation } from "react-i18next";
import { useShallow } from "zustand/react/shallow";
import { helpedOfState, resultsTask } from "../../model/classroom/dashboard.ts";
import { filters, type Filter } from "../../model/classroom/student-group.ts";
import { nextHelped, sortKeys } from "../../model/classroom/student-order.ts";
import { Button } from "../../ui/Button.tsx";
import { Segmented } from "../../ui/Segmented.tsx";
import { Select } from "../../ui/Select.tsx";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { cardFilters, hasFilter, notHereFilters } from "./card-filters.ts";
import { useContent, useDashboard } from "./dashboard-context.ts";
import { StudentCard } from "./StudentCard.tsx";
import { StandingChip } from "./StandingChip.tsx";
import { PictureArea } from "./StudentPicture.tsx";
import styles from "./student-cards.module.css";

/** A phone has room for these. */
const phoneFilters: readonly Filter[] = ["help", "all", "solved"];

interface StudentCardsProps {
  /** number of the student whose sheet is open */
  watched: number | null;
  onWatch: (student: number) => void;
}

export function StudentCards({ watched, onWatch }: StudentCardsProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { dashboard } = useContent();
  const [chosen, setChosen] = useState<Filter>("all");
  const order = useDashboard((state) => state.order);
  const sorting = useDashboard((state) => state.sorting);
  const bits = useDashboard(useShallow(cardFilters));
  const task = useDashboard(resultsTask);
  const hasTasks = useDashboard(({ lesson }) => (lesson?.tasks.length ?? 1) > 1);
  const missing = useDashboard(({ classroom, students }) =>
    Math.max(0, (classroom?.expected ?? 0) - students.size),
  );
  const isPhone = useMediaQuery("(max-width: 37.49em)");
  const list = useRef<HTMLUListElement>(null);
  const isEmpty = order.order.length === 0;
  useNextKey(list, () => setChosen("all"));
  useHold(list, isEmpty);
  const filtered = (each: Filter): number[] =>
    order.order.filter((_, at) => hasFilter(bits[at] ?? 0, each));
  const hasMissing = (each: Filter): boolean => missing > 0 && hasFilter(notHereFilters, each);
  const labelOf = (each: Filter): string => {
    const number = filtered(each).length + (hasMissing(each) ? missing : 0);
    return hasTasks && (each === "solved" || each === "working")
      ? t(`filter.${each}Task`, { number, task })
      : t(`filter.${each}`, { number });
  };
  const offered = (isPhone ? phoneFilters : filters).filter(
    (each) => each !== "elsewhere" || hasTasks,
  );
  const filter = offered.includes(chosen) ? chosen : "all";
  const students = filtered(filter);
  if (isEmpty) return null;
  return (
    <section className={styles["students"]} aria-label={t("students")}>
      <div className={styles["tools"]}>
        <div className={styles["filters"]}>
          <Segmented
            label={t("filter.label")}
            look="strip"
            value={filter}
            options={offered.map((value) => ({ value, label: labelOf(value) }))}
            onChange={setChosen}
          />
        </div>
        <label className={styles["sort"]}>
          <span aria-hidden="true">{t("sort.label")}</span>
          <Select
            label={t("sort.label")}
            value={sorting}
            options={sortKeys.map((value) => ({ value, label: t(`sort.${value}`) }))}
            onChange={(value) => dashboard.setSorting(value)}
          />
        </label>
      </div>
      <output className={styles["waiting"]}>
        {order.waiting > 0 && (
          <>
            {t("sort.waiting", { count: order.waiting })}
            <Button size="small" onClick={() => dashboard.sortNow()}>
              {t("sort.now")}
            </Button>
          </>
        )}
      </output>
      <PictureArea>
        <ul ref={list} className={styles["cards"]}>
          {students.map((student) => (
            <StudentCard
              key={student}
              student={student}
              isWatched={student === watched}
              onWatch={onWatch}
            />
          ))}
          {hasMissing(filter) && (
            <li className={styles["missing"]}>
              <span>{t("card.missing", { count: missing })}</span>
              <StandingChip state="not-here" />
            </li>
          )}
        </ul>
      </PictureArea>
      {students.length === 0 && !hasMissing(filter) && (
        <p className={styles["none"]}>{t("filter.none")}</p>
      )}
    </section>
  );
}

/** N moves the focus to the next student who needs help. @param showAll ends the filter */
function useNextKey(list: { readonly current: HTMLElement | null }, showAll: () => void): void {
  const { dashboard } = useContent();
  const show = useRef(showAll);
  useEffect(() => {
    show.current = showAll;
  });
  useEffect(() => {
    const press = (event: KeyboardEvent): void => {
      const isTyping =
        event.target instanceof Element && event.target.matches("input, textarea, select");
      const hasModifier = event.ctrlKey || event.metaKey || event.altKey;
      if (event.key.toLowerCase() !== "n" || isTyping || hasModifier) return;
      const { order } = dashboard.store.getState().order;
      const current = Number(document.activeElement?.getAttribute("data-student") ?? "0") || null;
      const next = nextHelped(order, helpedOfState(dashboard.store.getState()), current);
      if (next === null) return;
      const card = () => list.current?.querySelector<HTMLElement>(`[data-student="${next}"]`);
      // The filter hides the card of this student.
      if (!card()) flushSync(() => show.current());
      card()?.focus();
    };
    document.addEventListener("keydown", press);
    return () => document.removeEventListener("keydown", press);
  }, [dashboard, list]);
}

/** The cards stay where they are while the pointer or the focus is on one. */
function useHold(list: { readonly current: HTMLElement | null }, isEmpty: boolean): void {
  const { dashboard } = useContent();
  useEffect(() => {
    const element = list.current;
    if (element === null) return;
    const listen = (type: string, by: "pointer" | "focus", isHeld: boolean) => {
      const follow = (event: Event): void => {
        // A finger does not rest on a card.
        if (event instanceof PointerEvent && event.pointerType !== "mouse") return;
        dashboard.hold(by, isHeld);
      };
      element.addEventListener(type, follow);
      return () => element.removeEventListener(type, follow);
    };
    const stops = [
      listen("pointerenter", "pointer", true),
      listen("pointerleave", "pointer", false),
      listen("focusin", "focus", true),
      listen("focusout", "focus", false),
    ];
    return () => {
      for (const stop of stops) stop();
    };
  }, [dashboard, list, isEmpty]);
}
