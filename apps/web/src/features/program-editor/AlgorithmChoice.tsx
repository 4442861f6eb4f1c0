/**
 * A choice of preset algorithms. It asks for confirmation in the same place before it replaces the
 * student's own lines.
 */
import type { ProgramDocument } from "@corridor/program";
import { useRef, useState, type ReactNode } from "react";
import { flushSync } from "react-dom";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import { Button } from "../../ui/Button.tsx";
import styles from "./algorithm-choice.module.css";
import { chooseAlgorithm } from "./choose-algorithm.ts";
import { isOwnProgram } from "../../model/workspace/own-program.ts";

interface AlgorithmChoiceProps {
  /** called after an algorithm was loaded, so that a menu can close */
  onChosen?: (() => void) | undefined;
  /** renders the algorithms */
  children: (choose: (program: ProgramDocument) => void) => ReactNode;
}

export function AlgorithmChoice({ onChosen, children }: AlgorithmChoiceProps) {
  const { t, i18n } = useTranslation();
  const services = useServices();
  const [asked, setAsked] = useState<ProgramDocument | null>(null);
  const place = useRef<HTMLDivElement>(null);

  function load(program: ProgramDocument): void {
    setAsked(null);
    chooseAlgorithm(services, i18n, program);
    onChosen?.();
  }

  function keep(): void {
    flushSync(() => setAsked(null));
    place.current?.querySelector("button")?.focus();
  }

  if (asked !== null) {
    const count = services.workspace.getState().program.rules.length;
    return (
      <div className={styles["question"]} tabIndex={-1} ref={focus}>
        <p role="alert">{t("program.replace.question", { name: asked.name, count })}</p>
        <div className={styles["answers"]}>
          <Button kind="primary" onClick={() => load(asked)}>
            {t("program.replace.yes")}
          </Button>
          <Button onClick={keep}>{t("program.replace.no")}</Button>
        </div>
      </div>
    );
  }
  return (
    <div className={styles["list"]} ref={place}>
      {children((program) => {
        if (isOwnProgram(services.workspace.getState().program, i18n)) setAsked(program);
        else load(program);
      })}
    </div>
  );
}

/**
 * The pressed button is gone, and its place may be partly out of sight. The focus moves to the
 * question.
 */
function focus(question: HTMLElement | null): void {
  question?.focus();
}
