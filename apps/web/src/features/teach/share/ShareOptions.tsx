/** The ways to share a lesson: link, short link, QR code, other apps, Google Classroom, file. */
import type { LessonDocument } from "@corridor/challenge";
import { FileDown, GraduationCap } from "lucide";
import { useEffect, useId, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { sharedSearch } from "../../../model/preferences/language.ts";
import type { KeyValueStorage } from "../../../model/storage/key-value-storage.ts";
import { SharedLessons } from "../../../model/teaching/shared-lessons.ts";
import { useShortLink, type ShortLinkState } from "../../../model/use-short-link.ts";
import { Button } from "../../../ui/Button.tsx";
import { ButtonLink } from "../../../ui/ButtonLink.tsx";
import { FieldError } from "../../../ui/FieldError.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { EmbedCode } from "../../../ui/EmbedCode.tsx";
import { LinkField } from "../../../ui/LinkField.tsx";
import { PrintButton } from "../../../ui/print/PrintButton.tsx";
import { printedLink, printedMazes } from "../../../ui/print/printed-content.ts";
import { QrCard } from "../../../ui/QrCard.tsx";
import { saveDocument } from "../../../ui/save-file.ts";
import { ShareSheetButton } from "../../../ui/ShareSheetButton.tsx";
import { ShortLinkChoice } from "../../../ui/ShortLinkChoice.tsx";
import { useOnline } from "../../../ui/use-online.ts";
import { lessonName } from "../../../model/lessons/lesson-name.ts";
import styles from "./share-lesson-dialog.module.css";
import { shareSizesOf } from "./share-sizes.ts";
import { useExcessText } from "./use-excess-text.ts";

/**
 * Longest address, in characters, for a QR code that a camera reads across a classroom, and for a
 * query string: services cut or log long ones.
 */
const MAX_COMPACT_LENGTH = 250;

/** A name, which is the same in all languages. */
const CLASSROOM = "Google Classroom";

interface ShareOptionsProps {
  /** a valid lesson */
  lesson: LessonDocument;
  /** localStorage */
  device: KeyValueStorage;
}

export function ShareOptions({ lesson, device }: ShareOptionsProps) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const fileProblem = useId();
  const excessText = useExcessText();
  const { document, link, excesses } = useMemo(() => shareSizesOf(lesson), [lesson]);
  const short = useShortLink(document);
  // The teacher sees the link: students may have it from now on.
  useEffect(() => new SharedLessons(device).add(lesson), [device, lesson]);
  const { origin, search } = location;
  const long = link === null ? null : `${origin}/${sharedSearch(search)}#${link}`;
  const made = short.link === null ? null : short.link.address + sharedSearch(search);
  const address = made ?? long;
  const compact = long !== null && long.length <= MAX_COMPACT_LENGTH ? long : made;
  const name = lessonName(lesson);
  const lang = sharedSearch(search);
  const embedded =
    short.link !== null
      ? `${origin}/embed/m/${short.link.id}${lang}`
      : link && `${origin}/embed${lang}#${link}`;
  return (
    <div className={styles["columns"]}>
      <div className={styles["main"]}>
        {(address !== null || excesses.link !== undefined) && (
          <LinkField
            link={address}
            tooBig={excesses.link === undefined ? "" : excessText("link", excesses.link)}
          />
        )}
        {excesses.shortLink === undefined ? (
          <ShortLink short={short} />
        ) : (
          <p className={styles["note"]}>{excessText("shortLink", excesses.shortLink)}</p>
        )}
        {embedded !== null && <EmbedCode address={embedded} name={name} />}
        <div className={styles["answers"]}>
          {address !== null && (
            <ShareSheetButton data={{ title: name, url: address }} label={t("share.apps")} />
          )}
          {compact !== null && (
            <ButtonLink
              icon={<Icon of={GraduationCap} />}
              href={`https://classroom.google.com/share?${new URLSearchParams({ url: compact })}`}
              target="_blank"
              rel="noopener noreferrer"
            >
              {CLASSROOM}
            </ButtonLink>
          )}
          <PrintButton
            content={{
              language: lesson.language,
              mazes: printedMazes(lesson),
              link: printedLink(made, long),
            }}
          />
          {excesses.file === undefined && (
            <Button icon={<Icon of={FileDown} />} onClick={() => saveDocument(document, "lesson")}>
              {t("share.file")}
            </Button>
          )}
        </div>
        {excesses.file !== undefined && (
          <FieldError id={fileProblem}>{excessText("file", excesses.file)}</FieldError>
        )}
      </div>
      {compact !== null && <QrCard link={compact} name={name} />}
      {compact === null && address !== null && (
        <p className={styles["note"]}>{t("share.needsShortLink")}</p>
      )}
    </div>
  );
}

function ShortLink({ short }: { short: ShortLinkState }) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const isOnline = useOnline();
  if (short.isOffered === null) return null;
  if (!short.isOffered) {
    return <p className={styles["note"]}>{t(isOnline ? "share.noService" : "share.offline")}</p>;
  }
  return (
    <ShortLinkChoice
      isMade={short.link !== null}
      isBusy={short.isBusy}
      outcome={short.outcome}
      refusal={null}
      onMake={short.make}
      onDelete={short.remove}
    />
  );
}
