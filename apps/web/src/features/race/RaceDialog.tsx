/** The race: the robot and each ghost side by side, and a field to add a ghost from a link. */
import { Ghost, X } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { formatSeconds } from "../../text/numbers.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button, IconButton } from "../../ui/Button.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import type { RaceGhost } from "../../model/run/race-store.ts";
import type { Finish } from "../../simulator/protocol/worker-messages.ts";
import { AddGhost } from "./AddGhost.tsx";
import { raceService } from "./race-service.ts";
import styles from "./race.module.css";
import { useResultText } from "./result-text.ts";

interface RaceDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

export function RaceDialog({ isOpen, onClose }: RaceDialogProps) {
  const { t } = useTranslation("race", { useSuspense: false });
  return (
    <Dialog isOpen={isOpen} onClose={onClose} title={t("title")} subtitle={t("subtitle")}>
      <RaceTable onEnd={onClose} />
    </Dialog>
  );
}

function RaceTable({ onEnd }: { onEnd: () => void }) {
  const { t, i18n } = useTranslation("race", { useSuspense: false });
  const services = useServices();
  const { ghosts, you } = useStore(services.race);
  const result = useResultText();
  const race = raceService(services, i18n);
  const first = Math.min(
    ...[you, ...ghosts.map(({ finish }) => finish)].map((each) => each?.goalTick ?? Infinity),
  );
  const remove = ({ id }: RaceGhost) => {
    race.remove(id);
    if (ghosts.length === 1) onEnd();
  };
  return (
    <div className={styles["race"]}>
      <p className={styles["result"]}>{result}</p>
      <table className={styles["table"]}>
        <thead>
          <tr>
            <th scope="col">{t("who")}</th>
            <th scope="col">{t("time")}</th>
            <th scope="col">{t("bumps")}</th>
            <th scope="col">{t("lines")}</th>
            <th scope="col">
              <span className="visually-hidden">{t("actions")}</span>
            </th>
          </tr>
        </thead>
        <tbody>
          <tr data-first={you?.goalTick === first || undefined}>
            <th scope="row">{t("you")}</th>
            <Figures finish={you} open={t("open")} lastSpan={2} />
          </tr>
          {ghosts.map((ghost) => (
            <tr key={ghost.id} data-first={(ghost.finish?.goalTick ?? null) === first || undefined}>
              <th scope="row">
                {t("ghost", { badge: ghost.badge })}
                {ghost.finish?.driver === "program" && (
                  <span className={styles["program"]} dir="auto">
                    {ghost.program}
                  </span>
                )}
              </th>
              <Figures
                finish={ghost.finish}
                open={t(ghost.finish === null ? "loading" : "never")}
              />
              <td>
                <IconButton
                  label={t("remove", { badge: ghost.badge })}
                  onClick={() => remove(ghost)}
                >
                  <Icon of={X} />
                </IconButton>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      <AddGhost race={race} />
      <Button
        className={styles["end"]}
        icon={<Icon of={Ghost} />}
        onClick={() => {
          race.end();
          onEnd();
        }}
      >
        {t("end")}
      </Button>
    </div>
  );
}

interface FiguresProps {
  finish: Finish | null;
  /** text in place of a missing time */
  open: string;
  /** number of columns that the last figure spans */
  lastSpan?: number;
}

function Figures({ finish, open, lastSpan }: FiguresProps) {
  const { t, i18n } = useTranslation("race", { useSuspense: false });
  const tick = finish?.goalTick ?? null;
  return (
    <>
      <td>
        {tick === null ? open : t("seconds", { seconds: formatSeconds(tick, i18n.language) })}
      </td>
      <td>{finish?.bumps ?? "–"}</td>
      <td colSpan={lastSpan}>{linesText()}</td>
    </>
  );

  function linesText(): string | number {
    if (finish === null) return "–";
    return finish.driver === "program" ? finish.lines : t(finish.driver);
  }
}
