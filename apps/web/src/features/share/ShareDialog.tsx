/** The share dialog: a link that contains the maze, or a run in it, and its QR code. */
import { lessonOf } from "@corridor/challenge";
import { encodeLink, MAX_LINK_LENGTH } from "@corridor/link";
import { projectOf } from "@corridor/link/project";
import { sizeOf } from "@corridor/maze";
import { Info } from "lucide";
import { useEffect, useLayoutEffect, useMemo, useState } from "react";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { Dialog } from "../../ui/Dialog.tsx";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { sharedSearch } from "../../model/preferences/language.ts";
import { missionHash } from "../../model/address/mission-address.ts";
import { holdLink } from "./held-link.ts";
import { LinkField } from "./LinkField.tsx";
import { QrCard } from "./QrCard.tsx";
import { RunChoice } from "./RunChoice.tsx";
import styles from "./share.module.css";
import { ShortLinkChoice } from "./ShortLinkChoice.tsx";
import { useShortLink } from "./use-short-link.ts";
import { useSavedRun } from "./use-saved-run.ts";

export interface ShareDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

/** The content of the link, as the title names it. */
type SharedContent = "maze" | "challenge" | "run";

const titles = {
  maze: "share.title",
  challenge: "share.titleChallenge",
  run: "share.titleRun",
} as const;

export function ShareDialog({ isOpen, onClose }: ShareDialogProps) {
  const { t } = useTranslation();
  const [content, setContent] = useState<SharedContent>("maze");
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={t(titles[content])}
      subtitle={t("share.subtitle")}
      footer={
        <p className={styles["privacy"]}>
          <Icon of={Info} size={16} />
          {t("share.private")}
        </p>
      }
    >
      <ShareForm onContent={setContent} />
    </Dialog>
  );
}

function ShareForm({ onContent }: { onContent: (content: SharedContent) => void }) {
  const { t } = useTranslation();
  const { workspace, challenge: challengeStore } = useServices();
  const challenge = useStore(challengeStore, (state) => state.challenge);
  const mission = useStore(challengeStore, (state) => state.mission);
  const [withChallenge, setWithChallenge] = useState(true);
  const maze = useStore(workspace, (state) => state.maze);
  const program = useStore(workspace, (state) => state.program);
  const [withProgram, setWithProgram] = useState(false);
  const [withRun, setWithRun] = useState(false);
  const saved = useSavedRun(withRun);
  const run = saved?.ok === true ? saved.run : null;
  // A challenge includes its mazes.
  const task = withChallenge ? challenge : null;
  // A long run takes seconds to encode, so the result is memoized.
  const result = useMemo(() => {
    if (run !== null) return encodeLink({ run });
    const content = task === null ? { maze } : { lesson: lessonOf(task) };
    return encodeLink(withProgram ? { ...content, program } : content);
  }, [run, task, maze, withProgram, program]);
  const content = withRun ? "run" : task === null ? "maze" : "challenge";
  useLayoutEffect(() => onContent(content), [content, onContent]);
  const isTooLong = withRun && (run === null ? saved !== null : !result.ok);
  const { origin, pathname, search } = location;
  const link = result.ok ? `${origin}${pathname}${sharedSearch(search)}#${result.text}` : null;
  const isMore = withRun || (withProgram && task !== null);
  const document = useMemo(
    () => task ?? (withProgram ? projectOf(maze, program) : maze),
    [task, withProgram, maze, program],
  );
  const short = useShortLink(document);
  const { link: made } = short;
  // A mission has its own address.
  const ofMission =
    task !== null && mission !== null && !isMore
      ? `${origin}${pathname}${sharedSearch(search)}${missionHash(mission)}`
      : null;
  const shown = isMore || made === null ? (ofMission ?? link) : made.address + sharedSearch(search);
  // A long run does not belong in an address bar, and the bar already shows the address of a
  // mission.
  const held = result.ok && !withRun && mission === null ? result.text : null;
  useEffect(() => {
    if (held !== null) holdLink(workspace, window, held, withProgram ? "program" : "maze");
  }, [workspace, held, withProgram]);
  const tooBig = t("share.tooBig", { limit: MAX_LINK_LENGTH });
  const tooLong = t(run === null ? "timeline.share.tooMuch" : "timeline.share.tooLong");
  return (
    <div className={styles["columns"]}>
      <div className={styles["main"]}>
        <div className={styles["link"]}>
          <LinkField link={isTooLong ? null : shown} tooBig={withRun ? tooLong : tooBig} />
          <ShortLinkChoice short={short} isMore={isMore} />
        </div>
        <fieldset className={styles["choices"]}>
          <legend className={styles["label"]}>{t("share.contents")}</legend>
          <Checkbox
            label={t("share.maze")}
            note={t("share.mazeNote", { ...sizeOf(maze), count: maze.goals.length })}
            checked
            disabled
            onChange={() => undefined}
          />
          <Checkbox
            label={t("share.program")}
            note={t("share.programNote")}
            checked={withProgram || withRun}
            disabled={withRun}
            onChange={setWithProgram}
          />
          {challenge !== null && (
            <Checkbox
              label={t("share.challenge")}
              note={challenge.words.short}
              checked={withChallenge && !withRun}
              disabled={withRun}
              onChange={setWithChallenge}
            />
          )}
          <RunChoice isChosen={withRun} onChange={setWithRun} saved={saved} />
        </fieldset>
      </div>
      {shown !== null && !isTooLong && <QrCard link={shown} name={maze.name} />}
    </div>
  );
}
