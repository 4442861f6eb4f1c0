/** Runs the open program in a hundred other mazes and displays in which of them it works. */
import { Eye, RotateCcw, Square } from "lucide";
import { useEffect, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { RunOpener } from "../../model/projects/run-opener.ts";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { minutesFor } from "../../simulator/pool-worker/maze-trial.ts";
import type { TrialResult } from "../../simulator/protocol/trial-messages.ts";
import { createWorkerPool } from "../../simulator/worker-pool.ts";
import styles from "./other-mazes.module.css";
import { TrialChoices } from "./TrialChoices.tsx";
import { TrialGrid } from "./TrialGrid.tsx";
import { tryWhileOpen } from "./try-while-open.ts";
import { countOutcomes, seedsFrom, trialChoice, Trials, TRIALS } from "./trials.ts";

interface OtherMazesDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

/**
 * Opens when its translations have loaded. The trials start at the press, before React renders a
 * hundred tiles.
 */
export function OtherMazesDialog({ isOpen, onClose }: OtherMazesDialogProps) {
  const { t, ready } = useTranslation("otherMazes", { useSuspense: false });
  const services = useServices();
  const { trials } = trialsOfPage(services);
  const minutes = useStore(trialChoice, ({ side }) => minutesFor(side));
  useEffect(() => tryWhileOpen(services, trials), [services, trials]);
  return (
    <Dialog
      isOpen={isOpen && ready}
      onClose={onClose}
      title={t("title")}
      subtitle={t("rule", { count: minutes })}
    >
      <TrialRun onClose={onClose} />
    </Dialog>
  );
}

function TrialRun({ onClose }: { onClose: () => void }) {
  const { t } = useTranslation(["words", "otherMazes", "check"], { useSuspense: false });
  const services = useServices();
  const { trials, opener } = trialsOfPage(services);
  const [isOpening, setOpening] = useState(false);
  const choice = useStore(trialChoice);
  const { state, results, pictured } = useStore(trials.store);

  // A hundred tiles take as long to render as all the rest, so the dialog opens without them.
  const isGridDue = results.size > 0 || state !== "running";
  const [hasGrid, setGrid] = useState(isGridDue);
  if (isGridDue && !hasGrid) setGrid(true);
  const counts = countOutcomes(results);
  const seeds = seedsFrom(choice.first);
  const failure = seeds
    .map((seed) => results.get(seed))
    .find((result) => result !== undefined && result.outcome !== "works");
  const numbers = { works: counts.works, tried: results.size, all: TRIALS };
  const sentence = t(`otherMazes:sentence.${state === "idle" ? "running" : state}`, numbers);
  const home = opener.backAction();

  async function open(result: TrialResult): Promise<void> {
    if (isOpening) return;
    setOpening(true);
    const { maze, seed, outcome, tick } = result;
    const { kind, side } = choice;
    const name = t(`words:presets.random.names.${kind}`, { side, seed });
    const run = {
      maze: { ...maze, name },
      attempt: services.workspace.getState().program,
      ticks: tick,
    };
    const isOpen = await opener.open(run, outcome !== "works", {
      opened: t(`otherMazes:opened.${outcome}`, { name }),
      notOpened: t("check:notOpened"),
      back: t("otherMazes:back"),
    });
    setOpening(false);
    if (isOpen) onClose();
  }

  return (
    <div className={styles["trials"]}>
      <TrialChoices />
      <div className={styles["summary"]}>
        <div className={styles["result"]}>
          <p className={styles["sentence"]}>{sentence}</p>
          <p className={styles["counts"]}>
            {t("otherMazes:counts", { bumps: counts.bump, limits: counts["time-limit"] })}
          </p>
        </div>
        <div className={styles["buttons"]}>
          {failure !== undefined && (
            <Button kind="primary" icon={<Icon of={Eye} />} onClick={() => void open(failure)}>
              {t("otherMazes:showFailure")}
            </Button>
          )}
          {state === "running" ? (
            <Button icon={<Icon of={Square} />} onClick={() => trials.stop()}>
              {t("otherMazes:stop")}
            </Button>
          ) : (
            <Button
              icon={<Icon of={RotateCcw} />}
              onClick={() => trials.start(choice, services.workspace.getState().program)}
            >
              {t("otherMazes:again")}
            </Button>
          )}
          {home !== null && (
            <Button
              onClick={() => {
                home();
                onClose();
              }}
            >
              {t("otherMazes:back")}
            </Button>
          )}
        </div>
      </div>
      {/* Announced once, at the end: a screen reader cannot follow a hundred results. */}
      <output className="visually-hidden">
        {state === "done" || state === "stopped" ? sentence : ""}
      </output>
      {hasGrid ? (
        <TrialGrid
          seeds={seeds}
          results={results}
          pictured={pictured}
          onOpen={(result) => void open(result)}
        />
      ) : (
        <div className={styles["room"]} />
      )}
    </div>
  );
}

interface PageTrials {
  trials: Trials;
  opener: RunOpener;
}

/**
 * One instance for the page: the workers stay warm for a while, and the student can still return to
 * the original maze.
 */
let pageTrials: PageTrials | null = null;

function trialsOfPage(services: ReturnType<typeof useServices>): PageTrials {
  if (pageTrials === null) {
    const pool = createWorkerPool();
    const trials = new Trials(pool, (show, milliseconds) => setTimeout(show, milliseconds));
    pageTrials = { trials, opener: new RunOpener(services, pool) };
  }
  return pageTrials;
}
