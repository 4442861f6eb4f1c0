/** The program of the run on a big screen, with its number of lines. */
import { decodeLink } from "@corridor/link";
import { countLines } from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { ProgramLines } from "./ProgramLines.tsx";
import styles from "./big-screen.module.css";

export interface ScreenProgramProps {
  /** text of a link */
  link: string;
  /** the line that decides now; null: none */
  running: LineRef | null;
}

/** Nothing if the link is unreadable: the page of the student may be newer. */
export function ScreenProgram({ link, running }: ScreenProgramProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const program = useMemo(() => {
    const read = decodeLink(link);
    return read.ok ? (read.value.program ?? read.value.run?.program ?? null) : null;
  }, [link]);
  if (program === null) return null;
  return (
    <div className={styles["program"]}>
      <p>{t("card.lines", { count: countLines(program.rules) })}</p>
      <ProgramLines program={program} running={running} />
    </div>
  );
}
