/** The share dialog: a link that contains the maze, a lesson or a run, and its QR code. */
import { oldestDocumentOf, type LessonDocument } from "@corridor/challenge";
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
import { EmbedCode } from "../../ui/EmbedCode.tsx";
import { LinkField } from "../../ui/LinkField.tsx";
import { PrintButton } from "../../ui/print/PrintButton.tsx";
import { printedLink, printedMazes, type PrintedContent } from "../../ui/print/printed-content.ts";
import { QrCard } from "../../ui/QrCard.tsx";
import { RunChoice } from "./RunChoice.tsx";
import { classNames } from "../../ui/class-names.ts";
import field from "../../ui/field.module.css";
import styles from "./share.module.css";
import { TeachLink } from "./TeachLink.tsx";
import { ShortLinkChoice } from "../../ui/ShortLinkChoice.tsx";
import { useShortLink } from "../../model/use-short-link.ts";
import { useSavedRun } from "./use-saved-run.ts";

export interface ShareDialogProps {
  isOpen: boolean;
  onClose: () => void;
}

/** The content of the link, as the title names it. */
type SharedContent = "maze" | "challenge" | "lesson" | "run";

/** A lesson has loaded its texts. */
const titles = {
  maze: "words:share.title",
  challenge: "words:share.titleChallenge",
  lesson: "missions:lesson.share",
  run: "words:share.titleRun",
} as const;

export function ShareDialog({ isOpen, onClose }: ShareDialogProps) {
  const { t, i18n } = useTranslation();
  const [content, setContent] = useState<SharedContent>("maze");
  return (
    <Dialog
      isOpen={isOpen}
      onClose={onClose}
      title={i18n.t(titles[content])}
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
  const { t, i18n } = useTranslation();
  const { workspace, challenge: challengeStore } = useServices();
  const lesson = useStore(challengeStore, (state) => state.lesson);
  const mission = useStore(challengeStore, (state) => state.mission);
  const [withChallenge, setWithChallenge] = useState(true);
  const maze = useStore(workspace, (state) => state.maze);
  const program = useStore(workspace, (state) => state.program);
  const [withProgram, setWithProgram] = useState(false);
  const [withRun, setWithRun] = useState(false);
  const saved = useSavedRun(withRun);
  const run = saved?.ok === true ? saved.run : null;
  // A lesson includes its mazes.
  const shared = withChallenge ? lesson : null;
  const hasTasks = (shared?.tasks.length ?? 0) > 1;
  // The link would open the program with the first task, whose program it is not.
  const hasProgram = withProgram && !hasTasks;
  // A long run takes seconds to encode, so the result is memoized.
  const result = useMemo(() => {
    if (run !== null) return encodeLink({ run });
    const documents = shared === null ? { maze } : { lesson: shared };
    return encodeLink(hasProgram ? { ...documents, program } : documents);
  }, [run, shared, maze, hasProgram, program]);
  // Until the simulator has saved the run, the link has the documents.
  const content = withRun && saved !== null ? "run" : contentOf(shared);
  useLayoutEffect(() => onContent(content), [content, onContent]);
  const isTooLong = withRun && (run === null ? saved !== null : !result.ok);
  const { origin, pathname, search } = location;
  const link = result.ok ? `${origin}${pathname}${sharedSearch(search)}#${result.text}` : null;
  const isMore = withRun || (hasProgram && shared !== null);
  const document = useMemo(
    () =>
      shared === null ? (hasProgram ? projectOf(maze, program) : maze) : oldestDocumentOf(shared),
    [shared, hasProgram, maze, program],
  );
  const short = useShortLink(document);
  const { link: made } = short;
  // A mission has its own address.
  const ofMission =
    shared !== null && mission !== null && !isMore
      ? `${origin}${pathname}${sharedSearch(search)}${missionHash(mission)}`
      : null;
  const shown = isMore || made === null ? (ofMission ?? link) : made.address + sharedSearch(search);
  const lang = sharedSearch(search);
  const embedded =
    isMore || made === null
      ? result.ok && `${origin}/embed${lang}#${result.text}`
      : `${origin}/embed/m/${made.id}${lang}`;
  const printed: PrintedContent = {
    language: mission === null ? (shared?.language ?? null) : null,
    mazes:
      shared === null
        ? [{ maze, name: maze.name, task: t("program.goal"), lines: null }]
        : printedMazes(shared),
    link: isTooLong ? null : printedLink(shown, link),
  };
  // A long run does not belong in an address bar, and the bar already shows the address of a
  // mission.
  const held = result.ok && !withRun && mission === null ? result.text : null;
  useEffect(() => {
    if (held !== null) holdLink(workspace, window, held, hasProgram ? "program" : "maze");
  }, [workspace, held, hasProgram]);
  const tooBig = i18n.t(shared === null ? "words:share.tooBig" : "missions:lesson.tooBig", {
    limit: MAX_LINK_LENGTH,
  });
  const tooLong = t(run === null ? "timeline.share.tooMuch" : "timeline.share.tooLong");
  return (
    <div className={styles["columns"]}>
      <div className={styles["main"]}>
        <div className={styles["link"]}>
          <LinkField link={isTooLong ? null : shown} tooBig={withRun ? tooLong : tooBig} />
          {short.isOffered === true && (
            <ShortLinkChoice
              isMade={made !== null}
              isBusy={short.isBusy}
              outcome={short.outcome}
              // A short link does not carry a run, or a program with a challenge.
              refusal={isMore ? t("share.shortLink.alone") : null}
              onMake={short.make}
              onDelete={short.remove}
            />
          )}
        </div>
        <fieldset className={styles["choices"]}>
          <legend className={classNames(field["label"], styles["legend"])}>
            {t("share.contents")}
          </legend>
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
            checked={hasProgram || withRun}
            disabled={withRun || hasTasks}
            onChange={setWithProgram}
          />
          {lesson !== null && (
            <Checkbox
              label={i18n.t(
                lesson.tasks.length > 1 ? "missions:lesson.content" : "words:share.challenge",
              )}
              note={lesson.tasks.length > 1 ? lesson.name : (lesson.tasks[0]?.words.short ?? "")}
              checked={withChallenge && !withRun}
              disabled={withRun}
              onChange={setWithChallenge}
            />
          )}
          <RunChoice isChosen={withRun} onChange={setWithRun} saved={saved} />
        </fieldset>
        {result.ok && <TeachLink text={result.text} />}
        {embedded !== false && !isTooLong && (
          <EmbedCode address={embedded} name={shared?.name || maze.name} />
        )}
        {!withRun && (
          <div>
            <PrintButton content={printed} />
          </div>
        )}
      </div>
      {shown !== null && !isTooLong && <QrCard link={shown} name={maze.name} />}
    </div>
  );
}

function contentOf(lesson: LessonDocument | null): SharedContent {
  if (lesson === null) return "maze";
  return lesson.tasks.length > 1 ? "lesson" : "challenge";
}
