/** The dropdown editor: the lines from top to bottom, "otherwise", and a button for a new line. */
import { MAX_RULES } from "@corridor/program";
import { Fragment, useLayoutEffect, useRef, useState, type RefObject } from "react";
import { flushSync } from "react-dom";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import type { RunState } from "../../model/run/run-store.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import { lazyPart } from "../../ui/lazy-part.tsx";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { useRights } from "../../model/use-rights.ts";
import { AddLine } from "./AddLine.tsx";
import { isExample } from "../../model/workspace/example.ts";
import { LazyAdviceAnnouncement } from "./lazy-advice.ts";
import { decidingLine } from "../../model/run/line-state.ts";
import { Otherwise } from "./Otherwise.tsx";
import { addLine } from "../../model/workspace/program-actions.ts";
import styles from "./program-editor.module.css";
import { ProgramHeader } from "./ProgramHeader.tsx";
import { ProgramLine } from "./ProgramLine.tsx";
import { useRunningLine } from "./use-running-line.ts";
import { observeRoom } from "./observe-room.ts";

const EmptyProgram = lazyPart(async () => (await import("./EmptyProgram.tsx")).EmptyProgram);

/** In longer programs, the browser skips the lines that are out of sight. */
const FEW_LINES = 12;

export function ProgramEditor() {
  const { t } = useTranslation();
  const rights = useRights();
  const isPhone = useMediaQuery("(max-width: 37.49em)");
  // The challenge is driven by hand and permits no lines, so there is nothing to show.
  if (rights?.maxLines === 0 && rights.drivers[0] === "me") return null;
  return (
    <section className={styles["editor"]} aria-label={t("program.program")}>
      {/* On a phone the lines come first, because the sheet shows only three of them. */}
      {!isPhone && <ProgramHeader />}
      {isPhone && rights === null && <ExampleLabel />}
      <ProgramLines />
      {isPhone && <ProgramHeader />}
    </section>
  );
}

/**
 * The name of the example on the edge of its first line, where the header is out of sight below.
 */
function ExampleLabel() {
  const { workspace } = useServices();
  const name = useStore(workspace, ({ program }) => (isExample(program) ? program.name : null));
  if (name === null) return null;
  return (
    <p className={styles["label"]} aria-hidden="true">
      <span>{name}</span>
    </p>
  );
}

/** Does not render again while the robot drives. Each line subscribes to the run itself. */
function ProgramLines() {
  const { t } = useTranslation();
  const rights = useRights();
  const { workspace, screen, run, advice } = useServices();
  const program = useStore(workspace, (state) => state.program);
  const hasBegun = useStore(run, hasProgramBegun);
  const hasAnnouncement = useStore(advice, ({ announcement }) => announcement !== null);
  const lineIds = useStore(workspace, (state) => state.lineIds);
  const body = useRef<HTMLDivElement>(null);
  const rod = useRef<HTMLSpanElement>(null);
  const list = useRef<HTMLOListElement>(null);
  const otherwise = useRef<HTMLFieldSetElement>(null);
  const [remembered] = useState(() => new Map<number, number>());

  useLayoutEffect(() => {
    if (body.current && rod.current) return observeRoom(body.current, rod.current);
    return undefined;
  }, []);

  function add() {
    const id = flushSync(() => addLine(workspace));
    if (id === null) {
      showMessage(screen, { tone: "bad", text: t("program.full", { max: MAX_RULES }) });
      return;
    }
    document.querySelector<HTMLElement>(`#program-line-${id} select`)?.focus();
  }

  return (
    <div ref={body} className={styles["body"]} data-begun={hasBegun ? "" : undefined}>
      <span ref={rod} className={styles["rod"]} />
      {program.rules.length === 0 && rights === null && <EmptyProgram />}
      <ol
        ref={list}
        className={styles["lines"]}
        data-many={program.rules.length > FEW_LINES ? "" : undefined}
      >
        {program.rules.map((rule, index) => {
          const id = lineIds[index];
          if (id === undefined) return null;
          return (
            <Fragment key={id}>
              {/* Below the running line, this row notes that the following lines were not read. */}
              {index > 0 && (
                <li className={styles["rule"]} aria-hidden="true">
                  <span>{t("program.notRead")}</span>
                </li>
              )}
              <ProgramLine
                id={id}
                index={index}
                count={program.rules.length}
                rule={rule}
                remembered={remembered}
              />
            </Fragment>
          );
        })}
      </ol>
      <Otherwise element={otherwise} />
      <RunningLine list={list} otherwise={otherwise} />
      <AddLine onAdd={add} />
      <LazyAdviceAnnouncement isWanted={hasAnnouncement} />
    </div>
  );
}

function hasProgramBegun({ snapshot }: RunState): boolean {
  return decidingLine(snapshot) !== null && snapshot?.tick !== 0;
}

interface RunningLineProps {
  list: RefObject<HTMLOListElement | null>;
  otherwise: RefObject<HTMLElement | null>;
}

/** A separate component, so that its effect runs after the elements that it marks exist. */
function RunningLine({ list, otherwise }: RunningLineProps) {
  useRunningLine(list, otherwise);
  return null;
}
