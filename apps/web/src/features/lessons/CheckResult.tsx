/**
 * The check of the program in all mazes of the task: its progress, in how many mazes the program
 * passes, where it fails first, and the mazes by name, which open from there.
 */
import type { LessonTask } from "@corridor/challenge";
import { Eye } from "lucide";
import { useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { showsHelp } from "../../model/challenge/challenge-store.ts";
import type { MazeFailure } from "../../model/check/attempt-result.ts";
import {
  failureSentence,
  firstFailureSentence,
  reasonText,
  type CheckWords,
} from "../../model/check/failure-sentence.ts";
import { mazeName } from "../../model/check/maze-name.ts";
import type { LessonsService } from "../../model/lessons/lessons-service.ts";
import type { CheckProgress } from "../../model/lessons/program-check.ts";
import { useServices } from "../../model/use-services.ts";
import { groupedNumber } from "../../text/grouped-number.ts";
import { formatSeconds } from "../../text/numbers.ts";
import { Button } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { ProgressStrip } from "../../ui/ProgressStrip.tsx";
import styles from "./check-result.module.css";

interface CheckResultProps {
  task: LessonTask;
  service: LessonsService;
}

export function CheckResult({ task, service }: CheckResultProps) {
  const { challenge } = useServices();
  const hasBlame = useStore(challenge, ({ rights }) => showsHelp(rights, "blame"));
  const progress = useStore(service.check.progress);
  const { state, count } = progress;
  // A run in the only maze has shown its result.
  if (state === "idle" || count === 1) return null;
  if (state === "running") return <RunningCheck service={service} />;
  return <Finished task={task} service={service} progress={progress} hasBlame={hasBlame} />;
}

/** Renders nothing unless a check of several mazes runs. */
export function RunningCheck({ service }: Pick<CheckResultProps, "service">) {
  const { t, i18n } = useTranslation("check", { useSuspense: false });
  const progress = useStore(service.check.progress);
  const { state, done, count } = progress;
  if (state !== "running" || count === 1) return null;
  return (
    <div className={styles["check"]}>
      <p className={styles["sentence"]}>{progressText({ t, language: i18n.language }, progress)}</p>
      <ProgressStrip label={t("progress.label")} value={done} max={count} />
    </div>
  );
}

interface FinishedProps extends CheckResultProps {
  progress: CheckProgress;
  /** whether the task shows which line caused a failure */
  hasBlame: boolean;
}

function Finished({ task, service, progress, hasBlame }: FinishedProps) {
  const { t, i18n } = useTranslation("check", { useSuspense: false });
  const words: CheckWords = { t, language: i18n.language };
  const numberOf = (count: number): string => groupedNumber(count, i18n.language);
  const first = progress.first && withoutBlame(progress.first, hasBlame);
  const watch = (failure: MazeFailure): void => {
    const name = mazeName(t, task, failure.maze ?? 0);
    void service.watcher.watch(failure, name, failureSentence(words, task, failure));
  };
  const sentences = [
    progress.state === "stopped"
      ? progressText(words, progress)
      : t("result.passes", {
          passed: numberOf(progress.passed),
          all: numberOf(progress.count),
        }),
    ...(first === null ? [] : [firstFailureSentence(words, task, first)]),
  ];
  return (
    <div className={styles["check"]}>
      <div className={styles["row"]}>
        <p className={styles["sentence"]}>
          {sentences.map((sentence) => (
            <span key={sentence}>{sentence} </span>
          ))}
        </p>
        {first !== null && (
          <Button size="small" icon={<Icon of={Eye} />} onClick={() => watch(first)}>
            {t("result.watch")}
          </Button>
        )}
      </div>
      {progress.failures.length > 1 && (
        <MazeList
          summary={t("result.all", { found: numberOf(progress.failures.length) })}
          label={t("result.list")}
        >
          {() =>
            progress.failures.map((each) => {
              const failure = withoutBlame(each, hasBlame);
              return (
                <MazeRow
                  key={each.maze}
                  name={mazeName(t, task, each.maze ?? 0)}
                  reason={reasonText(words, task, failure.failure)}
                  onOpen={() => watch(failure)}
                />
              );
            })
          }
        </MazeList>
      )}
      {progress.passes.length > 0 && (
        <MazeList
          summary={t("result.passing", { found: numberOf(progress.passes.length) })}
          label={t("result.passingList")}
        >
          {() =>
            progress.passes.map((pass) => {
              const maze = mazeName(t, task, pass.maze);
              const seconds = formatSeconds(pass.ticks, i18n.language);
              const reason = t("result.passesIn", { seconds });
              const opened = t("failure.inMaze", { maze, reason });
              return (
                <MazeRow
                  key={pass.maze}
                  name={maze}
                  reason={reason}
                  onOpen={() => void service.watcher.open(pass, maze, opened)}
                />
              );
            })
          }
        </MazeList>
      )}
      {/* Announced once, at the end. */}
      <output className="visually-hidden">{sentences.join(" ")}</output>
    </div>
  );
}

interface MazeListProps {
  summary: string;
  /** name of the list */
  label: string;
  children: () => ReactNode;
}

/** Mazes by name. Up to a thousand rows are rendered only while the list is open. */
function MazeList({ summary, label, children }: MazeListProps) {
  const [isOpen, setOpen] = useState(false);
  return (
    <details onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary className={styles["summary"]}>{summary}</summary>
      {isOpen && (
        <ul className={styles["list"]} aria-label={label}>
          {children()}
        </ul>
      )}
    </details>
  );
}

interface MazeRowProps {
  /** of the maze, which opens its run */
  name: string;
  reason: string;
  onOpen: () => void;
}

function MazeRow({ name, reason, onOpen }: MazeRowProps) {
  return (
    <li className={styles["item"]}>
      <Button
        size="small"
        kind="quiet"
        icon={<Icon of={Eye} />}
        className={styles["watch"]}
        onClick={onOpen}
      >
        {name}
      </Button>
      <span className={styles["reason"]}>{reason}</span>
    </li>
  );
}

function progressText({ t, language }: CheckWords, { state, done, count }: CheckProgress): string {
  return t(state === "stopped" ? "progress.stopped" : "progress.running", {
    done: groupedNumber(done, language),
    all: groupedNumber(count, language),
  });
}

/** A failure without its line, where the task hides what caused it. */
function withoutBlame(failed: MazeFailure, hasBlame: boolean): MazeFailure {
  return hasBlame ? failed : { ...failed, failure: { ...failed.failure, line: null } };
}
